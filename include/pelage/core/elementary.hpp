// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <cmath>
#include <concepts>
#include <type_traits>

namespace pelage::inline PELAGE_ABI {

/// Functions that a loose driver gets wrong in the fourth digit, from + − × ÷ and √ alone: float has its own
/// polynomials, the same bits on every machine that rounds as IEEE 754 asks; wider types use std::.
///
/// Nothing here branches on data in float, so that a type that packs many floats runs through the same text: see
/// core/real_number.hpp; core/lanes.hpp supplies the functions marked "packed types overload".

/// x without its fraction, towards 0, for |x| < 2³¹. Packed types overload.
template <std::floating_point Real>
[[nodiscard]] constexpr Real whole_part(Real x) noexcept {
  return static_cast<Real>(static_cast<int>(x));
}

/// A number's whole part, and the power of two that has it for its exponent's bits.
template <class Real>
struct exponent_parts {
  Real whole;  ///< e, the argument towards 0
  Real power;  ///< 2^(e - 127); 0 for e = 0, +inf for e = 255
};

/// The parts of an argument in [0, 256).
template <single_precision Real>
[[nodiscard, gnu::always_inline]] inline constexpr exponent_parts<Real> split_exponent(Real biased) noexcept;

/// |x|, and 0 for -0.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real absolute(Real x) noexcept {
  return select(x > Real(0), x, Real(0) - x);
}

/// The lesser and the greater of two; b if either is NaN, in shaders too.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real least(Real a, Real b) noexcept {
  return select(a < b, a, b);
}
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real greatest(Real a, Real b) noexcept {
  return select(a > b, a, b);
}

/// eˣ - 1 for |x| ≤ 0.35, relative error below 1.5e-7 in float. Outside: garbage in float.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real small_exponential(Real x) noexcept;

/// eˣ, in float for x in [-87.3, 88.37] with a relative error below 2e-7; +inf from 88.38 on, below -87.3 denormals or
/// 0, from -87.69 on 0. NaN gives NaN, in a shader NaN or +inf.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real exponential(Real x) noexcept;

/// 1 - e⁻ˣ for x ≥ 0, relative error below 2e-7 in float however small x is. NaN gives NaN, in a shader NaN or -inf.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real one_minus_exponential(Real x) noexcept;

/// ln x for normal x > 0, within 1.4e-7 · max(1, |ln x|) in float. In float zero, denormals and negatives give -87.3.
template <std::floating_point Real>
[[nodiscard]] inline Real natural_logarithm(Real x) noexcept;

/// xʸ for a base in [0, 1] and an exponent in [0, inf): power_of_cosine() in float.
template <std::floating_point Real>
[[nodiscard]] inline Real power_of_share(Real x, Real y) noexcept;

/// The angle of the vector (x, y) without its sign, [0, π]: |atan2(y, x)|, relative error below 2e-7 in float where it
/// is normal. (0, 0) gives 0, -0 counts as 0. The length of the vector does not matter; NaN gives NaN, as do two
/// infinities in float. In a shader a vector shorter than 2⁻¹²⁶ and NaN give anything, and no part may be beyond 2¹²⁶.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real unsigned_angle(Real y, Real x) noexcept;

/// atan2(y, x), [-π, π], by unsigned_angle().
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real angle_of(Real y, Real x) noexcept;

/// The angle in [-π/2, π/2] whose sine is x, x clamped to [-1, 1]; relative error below 4e-7 in float where it is
/// normal. NaN gives NaN, in a shader anything.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real angle_of_sine(Real x) noexcept;

/// A point of the unit circle.
template <real_number Real>
struct rotation {
  Real cosine;
  Real sine;
};

/// (cos x, sin x), absolute error below 1.5e-7 in float for |x| ≤ 100, relative error of the sine below 2e-7 near 0.
/// In float garbage on the circle beyond 1e6. NaN and infinities give NaN.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline rotation<Real> rotation_by(Real x) noexcept;

/// The rotation by the sum of two angles.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline rotation<Real> turned_by(const rotation<Real>& a,
                                                                  const rotation<Real>& b) noexcept {
  return rotation<Real>{a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

/// The rotation by a's angle less b's.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline rotation<Real> turned_back(const rotation<Real>& a,
                                                                    const rotation<Real>& b) noexcept {
  return rotation<Real>{a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}

// ---------------------------------------------------------------------------------------------------------
template <single_precision Real>
constexpr exponent_parts<Real> split_exponent(Real biased) noexcept {
  const integer_of<Real> e = to_integer(biased);
  return exponent_parts<Real>{to_float(e), float_of_bits(e << 23)};
}

template <real_number Real>
Real small_exponential(Real x) noexcept {
  if constexpr (std::floating_point<Real> && sizeof(Real) > 4) {
    return std::expm1(x);
  } else {
    // In pairs, here and below: a shorter chain of dependent operations than Horner's.
    const Real s = x * x;
    const Real high = Real(0.000198909809f) * x + Real(0.00139336416f);
    const Real middle = Real(0.00833331048f) * x + Real(0.0416664667f);
    const Real low = Real(0.166666672f) * x + Real(0.5f);
    return x + s * (low + s * (middle + s * high));
  }
}

template <real_number Real>
Real exponential(Real x) noexcept {
  if constexpr (std::floating_point<Real> && sizeof(Real) > 4) {
    return std::exp(x);
  } else {
    // x = n ln 2 + r; the bounds keep n + 127 in [0, 255], whose ends are 0 and infinity as exponents.
    const Real held = select(x < Real(-100.0f), Real(-100.0f), select(x > Real(89.0f), Real(89.0f), x));
    const Real biased = held * Real(1.44269502f) + Real(127.5f);
    const exponent_parts<Real> e = split_exponent(select(biased > Real(0.0f), biased, Real(0.0f)));
    const Real n = e.whole - Real(127.0f);
    const Real r = (held - n * Real(0.693359375f)) + n * Real(0.000212194442f);
    return select(e.whole > Real(0.0f), small_exponential(r) + Real(1.0f), r - r) * e.power;
  }
}

template <real_number Real>
Real one_minus_exponential(Real x) noexcept {
  if constexpr (std::floating_point<Real> && sizeof(Real) > 4) {
    return -std::expm1(-x);
  } else {
    const Real negative = Real(0.0f) - x;
    return select(x < Real(0.35f), Real(0.0f) - small_exponential(negative), Real(1.0f) - exponential(negative));
  }
}

template <std::floating_point Real>
Real natural_logarithm(Real x) noexcept {
  if constexpr (sizeof(Real) > 4) {
    return std::log(x);
  } else {
    return fast_log2(x) * 0.693147182f;
  }
}

template <std::floating_point Real>
Real power_of_share(Real x, Real y) noexcept {
  if constexpr (sizeof(Real) > 4) {
    return std::pow(x, y);
  } else {
    return power_of_cosine(x, y);
  }
}

template <real_number Real>
Real unsigned_angle(Real y, Real x) noexcept {
  if constexpr (std::floating_point<Real> && sizeof(Real) > 4) {
    return x == Real(0) && y == Real(0) ? Real(0) : std::atan2(std::abs(y), x);
  } else {
    const Real up = absolute(y);
    const Real along = absolute(x);
    const Real shorter = least(up, along);
    const Real longer = greatest(along, up);  // NaN in one of both, wherever it comes from
    const Real t = select(longer > Real(0.0f), shorter / longer, shorter + longer);
    const Real s = t * t;
    const Real q = s * s;
    const Real top = Real(-0.00238699722f) * s + Real(0.0135077713f);
    const Real high = Real(-0.0358715393f) * s + Real(0.0625016913f);
    const Real middle = Real(-0.0865688026f) * s + Real(0.110337645f);
    const Real low = Real(-0.142785683f) * s + Real(0.199997395f);
    const Real p = Real(-0.333333313f) + s * ((low + q * middle) + q * q * (high + q * top));
    const Real octant = t + t * s * p;
    const Real quadrant = select(up > along, Real(1.57079637f) - octant, octant);
    return select(x < Real(0.0f), Real(3.14159274f) - quadrant, quadrant);
  }
}

template <real_number Real>
Real angle_of(Real y, Real x) noexcept {
  const Real angle = unsigned_angle(y, x);
  return select(y < Real(0), Real(0) - angle, angle);
}

template <real_number Real>
Real angle_of_sine(Real x) noexcept {
  const Real held = greatest(Real(-1), least(Real(1), x));
  return angle_of(held, square_root((Real(1) - held) * (Real(1) + held)));
}

template <real_number Real>
rotation<Real> rotation_by(Real x) noexcept {
  if constexpr (std::floating_point<Real> && sizeof(Real) > 4) {
    return rotation<Real>{std::cos(x), std::sin(x)};
  } else {
    // x = n π/2 + r with π/2 in three parts, of which the first two have few digits: n times them is exact.
    const Real magnitude = least(absolute(x), Real(1e6f)) + (x - x);
    const Real n = whole_part(least(magnitude, Real(1e6f)) * Real(0.636619747f) + Real(0.5f));
    const Real r = ((magnitude - n * Real(1.5703125f)) - n * Real(0.000483751297f)) - n * Real(7.54978942e-8f);
    const Real s = r * r;
    const Real sine = r + r * s * ((Real(-0.000195878907f) * s + Real(0.00833274797f)) * s + Real(-0.166666642f));
    const Real quartic = (Real(2.45479423e-05f) * s + Real(-0.00138883025f)) * s + Real(0.0416666642f);
    const Real cosine = (Real(1.0f) - Real(0.5f) * s) + s * s * quartic;
    // The quarter turn: n modulo 4 as halves and quarters of whole numbers.
    const Real quarter = n - Real(4.0f) * whole_part(n * Real(0.25f));
    const Real odd = quarter - Real(2.0f) * whole_part(quarter * Real(0.5f));
    const Real swapped_cosine = select(odd > Real(0.5f), Real(0.0f) - sine, cosine);
    const Real swapped_sine = select(odd > Real(0.5f), cosine, sine);
    const Real turned_cosine = select(quarter > Real(1.5f), Real(0.0f) - swapped_cosine, swapped_cosine);
    const Real turned_sine = select(quarter > Real(1.5f), Real(0.0f) - swapped_sine, swapped_sine);
    return rotation<Real>{turned_cosine, select(x < Real(0.0f), Real(0.0f) - turned_sine, turned_sine)};
  }
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
