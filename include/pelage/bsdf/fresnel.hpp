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

/// 1 - A(η, θ) = F (2 - F), [0, 1]: the opacity of a clear fibre that light meets in full, with its relative precision
/// where A is near 1. Energy: nothing is absorbed; what does not pass is reflected, at one surface or the other, and is
/// the fibre's to scatter. Where the fibre covers the share C of a beam, A C + 1 - C passes [Yu12 §3.1], so
/// optical_depth((1 - A) C) is this crossing's part of a sum of integers.
///
/// `eta`, `sin_theta` as above; along the fibre and beyond, or NaN: 1; without a change of index 0.
template <std::floating_point Real>
[[nodiscard]] Real fibre_opacity(Real eta, Real sin_theta) noexcept {
  const interface_shares<Real> surface =
      dielectric_interface(safe_sqrt((Real(1) - sin_theta) * (Real(1) + sin_theta)), eta);
  return surface.reflected * (Real(1) + surface.transmitted);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
