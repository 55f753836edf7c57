// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/passage.hpp>
#include <pelage/core/exact_begin.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

// The brightness of one fibre by itself, beside absorption_from_albedo(), which is that of a mass of hair: a colour of
// 0.1 for the mass (β_n = 0.3) makes a fibre that sends 0.76 of the light on.

/// The share of the light that one smooth fibre scatters, all lobes and the whole width, [0, 1]: ½ ∫ Σ A_p(h) dh, the
/// integral of Chiang's model over all directions, whatever its roughness. Falls with σ_a from 1 at 0 to the surface's
/// reflection alone.
///
/// `eta`: [1, 3]. `sigma_a`: per fibre radius, [0, inf]. `sin_theta`: of the light's inclination, [-1, 1]; at the ends
/// 1. Within 1e-3 of the integral, by 24 points across the width. A NaN σ_a counts as infinite.
template <std::floating_point Real>
[[nodiscard]] Real fibre_albedo(Real eta, Real sigma_a, Real sin_theta) noexcept;

/// σ_a, [0, 28.5], of the fibre whose fibre_albedo() in light across its axis is `colour`, [0, 1], within 1e-6. What is
/// no brighter than the surface's reflection (0.075 at η = 1.55) gives the upper end, the blackest fibre there is; from
/// 1 on 0; NaN the upper end. Some 40 evaluations of fibre_albedo(): once a material, not once a hit.
template <std::floating_point Real>
[[nodiscard]] Real absorption_from_fibre_albedo(Real colour, Real eta) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
Real fibre_albedo(Real eta, Real sigma_a, Real sin_theta) noexcept {
  const Real cosine = square_root(greatest((Real(1) - sin_theta) * (Real(1) + sin_theta), Real(0)));
  const Real held = least(sigma_a, Real(1e30));
  Real sum = Real(0);
  Real weights = Real(0);
  for (int node = 0; node < 24; ++node) {
    const width_node<Real> place = fibre_width_node<Real>(node, 8);
    const std::array<Real, 4> paths =
        detail::chiang_attenuation(detail::cross_chiang_section(eta, place.h, sin_theta, cosine), held);
    sum = sum + place.weight * ((paths[0] + paths[1]) + (paths[2] + paths[3]));
    weights = weights + place.weight;
  }
  return least(sum / weights, Real(1));
}

template <std::floating_point Real>
Real absorption_from_fibre_albedo(Real colour, Real eta) noexcept {
  Real dark = Real(0);
  Real light = Real(1);  // e^-σ_a lies between
  for (int halving = 0; halving < 41; ++halving) {
    const Real middle = Real(0.5) * (dark + light);
    const bool too_dark = fibre_albedo(eta, Real(0) - natural_logarithm(middle), Real(0)) < colour;
    dark = too_dark ? middle : dark;
    light = too_dark ? light : middle;
  }
  return colour >= Real(1) ? Real(0) : greatest(Real(0) - natural_logarithm(light), Real(0));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
