// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// What a fibre lets through to what lies behind it, per channel: the attenuation along shadow and view paths.
///
/// It is the TT lobe's A_1 = (1 - F)² T of the BSDF itself, so that a path that takes a fibre for a filter and one that
/// scatters in it agree: averaged over the width it is the integral of the TT lobe over all directions. Light that R,
/// TRT and the residual lobe take out of the path is what those lobes scatter. The lobe's spread is the one thing that
/// the straight path leaves out. Along the axis with σ_a = 0 it is fibre_attenuation(), the A(η, θ) of [Yu12 §3.1],
/// which knows neither the fibre's colour nor where across its width light meets it.

/// A_1 for a ray through the fibre's axis (h = 0). `sin_theta`: of the ray's inclination, [-1, 1]; 0 at the ends.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> axial_passage(Real eta, const std::array<Real, 3>& sigma_a, Real sin_theta) noexcept;

/// One point of a rule over the fibre's width: h = sin γ, which takes the square roots at the edges out of the
/// integrand, and three Gauss points in each of equal parts of γ.
template <std::floating_point Real>
struct width_node {
  Real h;       ///< place across the width, (-1, 1)
  Real weight;  ///< its part of the average; all weights sum to 1 within 1e-5 from 2 panels on
};

/// Node `node` of the rule with `panels` parts, [0, 3 panels).
template <std::floating_point Real>
[[nodiscard]] inline width_node<Real> fibre_width_node(int node, int panels) noexcept;

/// A_1 averaged over the width, ½ ∫ A_1(h) dh, by that rule. For η in [1, 3], any absorption
/// and inclination, 2 panels are within 7.5e-3, 4 within 2e-3 and 8 within 5e-4.
template <int Panels, std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> mean_passage(Real eta, const std::array<Real, 3>& sigma_a, Real sin_theta) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// A_1 of a section for red, green, blue.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> colour_passage(const chiang_section<Real>& section,
                                               const std::array<Real, 3>& sigma_a) noexcept {
  return glm::vec<3, Real>(chiang_attenuation(section, sigma_a[0])[1], chiang_attenuation(section, sigma_a[1])[1],
                           chiang_attenuation(section, sigma_a[2])[1]);
}

}  // namespace detail

template <std::floating_point Real>
glm::vec<3, Real> axial_passage(Real eta, const std::array<Real, 3>& sigma_a, Real sin_theta) noexcept {
  const Real cosine = square_root(greatest((Real(1) - sin_theta) * (Real(1) + sin_theta), Real(0)));
  const detail::chiang_section<Real> section = detail::cross_chiang_section(eta, Real(0), sin_theta, cosine);
  return detail::colour_passage(section, sigma_a);
}

template <std::floating_point Real>
width_node<Real> fibre_width_node(int node, int panels) noexcept {
  const Real panel = Real(3.141592653589793238) / Real(panels);
  const int whole = node / 3;
  const int place = node - 3 * whole - 1;
  const Real gamma =
      panel * (Real(whole) + Real(0.5) + Real(place) * Real(0.387298334620741688)) - Real(1.57079632679489662);
  const rotation<Real> offset = rotation_by(gamma);
  const Real gauss = place == 0 ? Real(0.444444444444444444) : Real(0.277777777777777778);
  return width_node<Real>{offset.sine, Real(0.5) * panel * gauss * offset.cosine};
}

template <int Panels, std::floating_point Real>
glm::vec<3, Real> mean_passage(Real eta, const std::array<Real, 3>& sigma_a, Real sin_theta) noexcept {
  static_assert(Panels >= 1 && Panels <= 64, "the width of a fibre is cut into 1 to 64 panels");
  const Real cosine = square_root(greatest((Real(1) - sin_theta) * (Real(1) + sin_theta), Real(0)));
  glm::vec<3, Real> passage = glm::vec<3, Real>(Real(0));
  for (int node = 0; node < 3 * Panels; ++node) {
    const width_node<Real> place = fibre_width_node<Real>(node, Panels);
    const detail::chiang_section<Real> section = detail::cross_chiang_section(eta, place.h, sin_theta, cosine);
    passage = passage + place.weight * detail::colour_passage(section, sigma_a);
  }
  return passage;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
