// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// Light spread round the fibre: a logistic distribution of the azimuth, trimmed to [-π, π] and normalised there.
/// Made once per roughness. [Chiang 2016 §3.2]
template <real_number Real>
struct azimuthal_lobe {
  Real scale;      ///< s, [1e-5, inf)
  Real steepness;  ///< -1/s
  Real height;     ///< 1/(s tanh(π/(2s))): what normalises on [-π, π]
};

/// The lobe of scale s in radians, clamped to at least 1e-5; NaN gives that.
template <real_number Real>
[[nodiscard]] inline azimuthal_lobe<Real> make_azimuthal_lobe(Real scale) noexcept;

/// N(x) per radian at a distance x in [0, π] from the middle. Relative error below 4e-7 (1 + x/s) in float where
/// x ≤ 87 s and N is normal; beyond, 0 or what is left of a denormal exponential.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real evaluate_azimuthal(const azimuthal_lobe<Real>& lobe,
                                                                 Real from_middle) noexcept;

/// Draws a signed distance from the middle, [-π, π], with density N from a number in [0, 1).
template <std::floating_point Real>
[[nodiscard]] inline Real sample_azimuthal(const azimuthal_lobe<Real>& lobe, Real u) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <real_number Real>
azimuthal_lobe<Real> make_azimuthal_lobe(Real scale) noexcept {
  const Real s = greatest(scale, Real(1e-5));
  // tanh(π/(2s)) = (1 - e^(-π/s)) / (1 + e^(-π/s)).
  const Real miss = one_minus_exponential(Real(3.141592653589793238) / s);
  return azimuthal_lobe<Real>{s, Real(-1) / s, (Real(2) - miss) / (s * miss)};
}

template <real_number Real>
Real evaluate_azimuthal(const azimuthal_lobe<Real>& lobe, Real from_middle) noexcept {
  const Real e = exponential(from_middle * lobe.steepness);
  const Real sum = Real(1) + e;
  return lobe.height * e / (sum * sum);
}

template <std::floating_point Real>
Real sample_azimuthal(const azimuthal_lobe<Real>& lobe, Real u) noexcept {
  // The quantile of the logistic between its values at -π and π, from whichever end is nearer.
  const Real end = exponential(Real(-3.141592653589793238) / lobe.scale);
  const Real below = end / (Real(1) + end);
  const Real inside = (Real(1) - end) / (Real(1) + end);
  const Real low = below + u * inside;
  const Real high = below + (Real(1) - u) * inside;
  const Real drawn = lobe.scale * (natural_logarithm(low) - natural_logarithm(high));
  return least(greatest(drawn, Real(-3.141592653589793238)), Real(3.141592653589793238));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
