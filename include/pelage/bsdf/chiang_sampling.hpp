// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <concepts>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// The BSDF itself and its density, as a path tracer wants them.
template <std::floating_point Real>
struct chiang_bsdf {
  glm::vec<3, Real> f;  ///< scattering divided by |w_i.z|, for renderers that multiply by it
  Real density;         ///< of sample_chiang() drawing w_i, per steradian
};

/// A direction drawn for a light, with what evaluate_chiang() says of it.
template <std::floating_point Real>
struct chiang_sample {
  glm::vec<3, Real> direction;  ///< unit length within 3e-7 in float
  chiang_result<Real> result;   ///< value/density is the sample's weight; both are 0 of black fibres alone
  std::uint32_t lobe;           ///< 0 R, 1 TT, 2 TRT, 3 residual
};

/// f and density for two unit vectors in the fibre's frame; one call for what a view and a light cost apart. Where
/// w_i.z is 0 and f has no value, f |cos| is returned in its place.
template <std::floating_point Real>
[[nodiscard]] chiang_bsdf<Real> evaluate_chiang_bsdf(const chiang_fibre<Real>& fibre, Real h,
                                                     const glm::vec<3, Real>& w_o,
                                                     const glm::vec<3, Real>& w_i) noexcept;

/// Draws a direction from four numbers in [0, 1): lobe by its weight, then M's two and N's one. The density is that of
/// chiang_density(), all lobes together, so a weight stays below about 3 however rough the fibre is.
/// [Chiang 2016; d'Eon 2013]
template <std::floating_point Real>
[[nodiscard]] chiang_sample<Real> sample_chiang(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                                                const std::array<Real, 4>& u) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// A lobe's weight, or 0 where one float in [0, 1) at most would draw it: its directions may have density 0.
template <std::floating_point Real>
[[nodiscard]] inline Real weight_to_draw(Real weight) noexcept {
  return weight > Real(3e-8) ? weight : Real(0);
}

/// The lobe that a number in [0, 1) picks by its weight. A lobe of weight 0 is not picked, unless all are.
template <std::floating_point Real>
[[nodiscard]] inline std::uint32_t pick_chiang_lobe(const std::array<Real, 4>& weights, Real u) noexcept {
  const Real tt = weight_to_draw(weights[1]);
  const Real trt = weight_to_draw(weights[2]);
  const Real residual = weight_to_draw(weights[3]);
  const Real first = weight_to_draw(weights[0]);
  const Real second = first + tt;
  const Real third = second + trt;
  return u >= third && residual > Real(0)
             ? 3u
             : (u >= second && trt > Real(0) ? 2u : (u >= first && tt > Real(0) ? 1u : 0u));
}

/// Draws a direction from one lobe: its M round the eye's tilted inclination, its N round the middle, or for the
/// `residual` lobe any azimuth. Takes the last three of the four numbers.
template <std::floating_point Real>
[[nodiscard]] inline glm::vec<3, Real> draw_chiang_direction(const longitudinal_lobe<Real>& along,
                                                             const azimuthal_lobe<Real>& around,
                                                             const rotation<Real>& tilted, const rotation<Real>& middle,
                                                             bool residual, const std::array<Real, 4>& u) noexcept {
  const Real from_middle = residual ? Real(6.283185307179586477) * u[3] : sample_azimuthal(around, u[3]);
  const rotation<Real> inclination = sample_longitudinal(along, tilted.sine, tilted.cosine, u[1], u[2]);
  const rotation<Real> azimuth = turned_by(middle, rotation_by(from_middle));
  // Along the fibre too the vector keeps the azimuth, by which it is evaluated.
  const Real outward = greatest(inclination.cosine, Real(1e-18));
  const Real across = outward / square_root(azimuth.cosine * azimuth.cosine + azimuth.sine * azimuth.sine);
  return glm::vec<3, Real>(inclination.sine, across * azimuth.cosine, across * azimuth.sine);
}

}  // namespace detail

template <std::floating_point Real>
chiang_bsdf<Real> evaluate_chiang_bsdf(const chiang_fibre<Real>& fibre, Real h, const glm::vec<3, Real>& w_o,
                                       const glm::vec<3, Real>& w_i) noexcept {
  const chiang_view<Real> view = view_chiang(fibre, h, fibre_direction_of(w_o));
  const chiang_result<Real> result = evaluate_chiang(fibre, view, fibre_direction_of(w_i));
  const Real cosine = absolute(w_i.z);
  const Real divisor = cosine > Real(0) ? cosine : Real(1);
  return chiang_bsdf<Real>{result.value / divisor, result.density};
}

template <std::floating_point Real>
chiang_sample<Real> sample_chiang(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                                  const std::array<Real, 4>& u) noexcept {
  chiang_sample<Real> drawn;
  drawn.lobe = detail::pick_chiang_lobe(view.weights, u[0]);
  longitudinal_lobe<Real> along = fibre.longitudinal[3];
  rotation<Real> tilted = rotation<Real>{view.eye.cosine, view.eye.sine};
  rotation<Real> middle = rotation<Real>{view.eye.y, view.eye.z};
  for (std::uint32_t p = 0u; p < 3u; ++p) {
    if (p == drawn.lobe) {
      along = fibre.longitudinal[p];
      tilted = view.tilted[p];
      middle = view.towards[p];
    }
  }
  drawn.direction = detail::draw_chiang_direction(along, fibre.azimuthal, tilted, middle, drawn.lobe == 3u, u);
  drawn.result = evaluate_chiang(fibre, view, fibre_direction_of(drawn.direction));
  return drawn;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
