// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/interface.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// The share of unpolarised light that a smooth dielectric surface reflects, [0, 1]: dielectric_interface() for a
/// cosine of any sign, clamped to [0, 1]. NaN gives 1.
template <std::floating_point Real>
[[nodiscard]] Real fresnel_dielectric(Real cos_theta, Real eta) noexcept {
  return dielectric_interface(saturate(absolute(cos_theta)), eta).reflected;
}

/// A(η, θ): the share of light that passes a clear fibre through its axis, in and out again: (1 - F)², [0, 1].
/// What passes without absorption; the fibre's colour multiplies it. [Yu12 §3.1] names A and prints no form of it; this
/// is the A(1, 0) of Marschner 2003, Eq. 8, without absorption.
///
/// `eta`: the fibre's index, (0, 1e18); hair 1.55. `sin_theta`: sine of the light's inclination from the plane at
/// right angles to the fibre, [-1, 1]; at ±1 (along the fibre) and beyond, or NaN: 0.
template <std::floating_point Real>
[[nodiscard]] Real fibre_attenuation(Real eta, Real sin_theta) noexcept {
  return sqr(dielectric_interface(safe_sqrt((Real(1) - sin_theta) * (Real(1) + sin_theta)), eta).transmitted);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
