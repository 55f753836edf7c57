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

/// Draws a signed distance from the middle, [-π, π], with density N from a number in [0, 1). The
/// outermost 3e-8 on each side of a narrow lobe is drawn in at its edge, beyond which N would be 0.
template <std::floating_point Real>
[[nodiscard]] inline Real sample_azimuthal(const azimuthal_lobe<Real>& lobe, Real u) noexcept;

/// A lobe whose middle is spread evenly over a width: what stands for all offsets of one part of a fibre's width.
template <real_number Real>
struct azimuthal_band {
  Real scale;   ///< of the logistic, √(s² + (width/10)²) for a lobe of scale s
  Real width;   ///< over which the middle is spread, radians
  Real spread;  ///< 2 cosh(width/(2 scale))
  Real height;  ///< 2 sinh(width/(2 scale))/width, normalised as the lobe is
};

/// The band that stands for `extent` radians, [0, π), of middles. Where that is below 0.7 of the lobe's scale the band
/// is the lobe itself within 2e-3: lobes that close to one another add up without ripples.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline azimuthal_band<Real> make_azimuthal_band(const azimuthal_lobe<Real>& lobe,
                                                                                  Real extent) noexcept;

/// Its density per radian at a distance x in [0, π] from its middle. Over both sides the integral is 1 within 1e-4 for
/// extents up to 0.4, more than chiang_far_field.hpp asks for; of greater ones up to 0.05 lie beyond π and are lost.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real evaluate_azimuthal(const azimuthal_band<Real>& band,
                                                                 Real from_middle) noexcept;

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
  const Real low = greatest(below + u * inside, Real(3e-8));
  const Real high = greatest(below + (Real(1) - u) * inside, Real(3e-8));
  const Real drawn = lobe.scale * (natural_logarithm(low) - natural_logarithm(high));
  return least(greatest(drawn, Real(-3.141592653589793238)), Real(3.141592653589793238));
}

template <real_number Real>
azimuthal_band<Real> make_azimuthal_band(const azimuthal_lobe<Real>& lobe, Real extent) noexcept {
  const Real scale2 = lobe.scale * lobe.scale;
  const Real width2 = greatest(extent * extent - Real(0.5) * scale2, least(Real(0.04) * scale2, Real(0.0025)));
  const Real width = square_root(width2);
  // A tenth of the width more smooths the corners that the even spread leaves.
  const Real scale = square_root(scale2 + Real(0.01) * width2);
  const Real end = exponential(Real(0.5) * width / scale);
  const Real reciprocal = Real(1) / end;
  return azimuthal_band<Real>{scale, width, end + reciprocal, (end - reciprocal) / width * (lobe.height * lobe.scale)};
}

template <real_number Real>
Real evaluate_azimuthal(const azimuthal_band<Real>& band, Real from_middle) noexcept {
  // The logistic's distribution function at both ends, one minus the other.
  const Real e = exponential(Real(0) - from_middle / band.scale);
  return band.height * e / (Real(1) + e * (band.spread + e));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
