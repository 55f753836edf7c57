// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/math.hpp>

#include <cmath>
#include <concepts>

namespace pelage {

/// The share of unpolarised light that a smooth dielectric surface reflects, [0, 1]: exact Fresnel equations.
///
/// `cos_theta`: cosine of the angle of incidence; its sign does not matter, clamped to [0, 1]. `eta`: index of
/// refraction behind the surface over that before it, (0, 1e18); below 1 total internal reflection gives 1.
/// At grazing incidence (0): 1; eta = 1 gives 0 except for cos_theta below 1e-18, which counts as grazing. NaN gives 1.
/// In float within 1e-6 relative for eta in [1, 1000]; in [0.3, 1) the error grows to 5e-4 beside the critical angle.
template <std::floating_point Real>
[[nodiscard]] Real fresnel_dielectric(Real cos_theta, Real eta) noexcept;

/// A(η, θ): the share of light that passes a clear fibre through its axis, in and out again: (1 - F)², [0, 1].
/// What passes without absorption; the fibre's colour multiplies it. [Yu12 Eq. 2]
///
/// `eta`: the fibre's index, (0, inf); hair 1.55. `sin_theta`: sine of the light's inclination from the plane at
/// right angles to the fibre, [-1, 1]; at ±1 (along the fibre) and beyond, or NaN: 0.
template <std::floating_point Real>
[[nodiscard]] Real fibre_attenuation(Real eta, Real sin_theta) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
Real fresnel_dielectric(Real cos_theta, Real eta) noexcept {
  const Real cos_i = saturate(std::abs(cos_theta));
  // eta² cos²θt = eta² - sin²θi, written so that nothing cancels at eta near 1 and grazing light.
  const Real contrast = (eta - Real(1)) * (eta + Real(1));
  const Real inside2 = contrast + cos_i * cos_i;
  if (!(inside2 > Real(0)) || cos_i == Real(0)) {
    return Real(1);
  }
  const Real inside = std::sqrt(inside2);
  // Both amplitudes (a - b) / (a + b) as (a² - b²) / (a + b)²: the difference of squares is known without cancelling.
  const Real across = cos_i + inside;
  const Real along = eta * eta * cos_i + inside;
  const Real perpendicular = contrast / across / across;
  const Real parallel = contrast / along * ((eta * eta + Real(1)) * cos_i * cos_i - Real(1)) / along;
  return saturate(Real(0.5) * (perpendicular * perpendicular + parallel * parallel));
}

template <std::floating_point Real>
Real fibre_attenuation(Real eta, Real sin_theta) noexcept {
  const Real cos_theta = safe_sqrt((Real(1) - sin_theta) * (Real(1) + sin_theta));
  return sqr(Real(1) - fresnel_dielectric(cos_theta, eta));
}

}  // namespace pelage
