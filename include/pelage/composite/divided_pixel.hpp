// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/tail.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/real_number.hpp>

#include <glm/vec3.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// What is opaque behind the fibres of a pixel that an object's edge divides: two surfaces, the nearer one in a share
/// of the pixel only. Fibres before the edge are seen before both, those behind it before the farther one alone, as if
/// each part were a pixel of its own. To multiply the coverage of those by their part of the pixel would let many of
/// them, whose transmittances multiply, hide the nearer surface as well.
template <std::floating_point Real>
struct divided_backdrop {
  Real edge;                    ///< view depth of the nearer surface; a fibre at or behind it is behind; +inf: no edge
  Real far_share;               ///< of the pixel, in which the farther surface is seen, [0, 1]
  glm::vec<3, Real> far_light;  ///< its radiance times that share, linear RGB, finite
  glm::vec<3, Real> all_light;  ///< the mean radiance of the whole pixel without fibres, far_light included
};

/// Where opaque samples of a pixel part into two surfaces: those before this depth are the nearer one's, which lies at
/// their mean depth. The harmonic mean of the depths of the nearest and the farthest, (0, inf]: the middle between them
/// as perspective sees it. Where all are as far, all or none of them are before it, and there is no edge.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real parting_depth(Real nearest, Real farthest) noexcept {
  return Real(2) / (Real(1) / nearest + Real(1) / farthest);
}

/// The two parts of a pixel while its fibres are added front to back: exact where the samples of each of the two
/// surfaces are at one depth. The same bits as pixel_radiance has while nothing lies behind the edge and all radiance
/// is finite; infinite radiance gives NaN.
template <std::floating_point Real>
struct divided_pixel {
  pixel_radiance<Real> near_part;  ///< of the fibres before the edge
  pixel_radiance<Real> far_part;   ///< of all fibres
};

/// A pixel with nothing in it.
template <std::floating_point Real>
[[nodiscard]] constexpr divided_pixel<Real> empty_divided_pixel() noexcept {
  return divided_pixel<Real>{empty_pixel<Real>(), empty_pixel<Real>()};
}

/// The pixel with one more fibre behind the others, the rest as for pixel_radiance. `is_before_edge`: its depth is
/// below divided_backdrop::edge; false for all that come after the first for which it is. O(1).
template <std::floating_point Real>
[[nodiscard]] constexpr divided_pixel<Real> add_fibre(const divided_pixel<Real>& pixel, bool is_before_edge,
                                                      const glm::vec<3, Real>& scattered,
                                                      const glm::vec<3, Real>& attenuation, Real coverage) noexcept {
  const pixel_radiance<Real> whole = add_fibre(pixel.far_part, scattered, attenuation, coverage);
  return divided_pixel<Real>{is_before_edge ? whole : pixel.near_part, whole};
}

/// The pixel with what lies behind its fibres, as add_tail() of a pixel_radiance: `before` holds the fragments before
/// the edge, `behind` the others. Both are sums of integers, so that no order of arrival changes them.
[[nodiscard]] inline divided_pixel<float> add_tails(const divided_pixel<float>& pixel, const tail& before,
                                                    const tail& behind) noexcept {
  return divided_pixel<float>{add_tail(pixel.near_part, before), add_tail(pixel.far_part, merge(before, behind))};
}

/// What is seen of the pixel, linear RGB. With no fibre behind the edge the bits of resolve(near_part, all_light).
template <std::floating_point Real>
[[nodiscard]] constexpr glm::vec<3, Real> resolve(const divided_pixel<Real>& pixel,
                                                  const divided_backdrop<Real>& backdrop) noexcept {
  return resolve(pixel.near_part, backdrop.all_light) +
         backdrop.far_share * (pixel.far_part.radiance - pixel.near_part.radiance) +
         (pixel.far_part.transmittance - pixel.near_part.transmittance) * backdrop.far_light;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
