// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/real_number.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace pelage::inline PELAGE_ABI {

/// x².
template <std::floating_point Real>
[[nodiscard]] constexpr Real sqr(Real x) noexcept {
  return x * x;
}

/// √x, and 0 where x is negative or NaN: the guard for 1 - sin² that rounding made negative. Denormals, which a GPU
/// may flush, count as 0.
template <std::floating_point Real>
[[nodiscard]] Real safe_sqrt(Real x) noexcept {
  return x >= std::numeric_limits<Real>::min() ? std::sqrt(x) : Real(0);
}

/// x clamped to [0, 1]; NaN gives 0.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline constexpr Real saturate(Real x) noexcept {
  return select(x > Real(0), select(x < Real(1), x, Real(1)), Real(0));
}

/// The sum of two, clamped to 2³² - 1. Associative and commutative.
template <natural_number Natural>
[[nodiscard, gnu::always_inline]] inline constexpr Natural add_saturating(Natural a, Natural b) noexcept;

/// log₂ x from + − × alone, so that every machine agrees on its bits. For normal x > 0 within
/// 1e-7 · max(1, |log₂ x|). Zero, denormals and negatives give -126, the least exponent; NaN gives NaN, +inf 128.
template <single_precision Real>
[[nodiscard, gnu::always_inline]] inline constexpr Real fast_log2(Real x) noexcept;

/// 2ˣ from + − × alone, relative error below 1e-7 for x in [-126, 128). Below: 0. From 128 on: +inf. NaN gives NaN.
/// fast_log2() and this are constant expressions where x and the result are finite.
template <single_precision Real>
[[nodiscard, gnu::always_inline]] inline constexpr Real fast_exp2(Real x) noexcept;

/// xʸ for a base in [0, 1] and an exponent in [0, inf), as a highlight's lobe needs it: 0⁰ is 1, 0ʸ is 0. Relative
/// error below 2e-7 · (1 + y |log₂ x|) where the result is normal; smaller results are 0. A base that is denormal,
/// negative or NaN counts as 0, and so does an exponent that is denormal or negative; one of NaN gives NaN.
template <single_precision Real>
[[nodiscard, gnu::always_inline]] inline constexpr Real power_of_cosine(Real x, Real y) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <natural_number Natural>
constexpr Natural add_saturating(Natural a, Natural b) noexcept {
  const Natural room = Natural(0xffffffffu) - a;
  return a + select(b < room, b, room);
}

template <single_precision Real>
constexpr Real fast_log2(Real x) noexcept {
  using integer = integer_of<Real>;
  const Real finite = select(x > Real(3.40282347e38f), Real(3.40282347e38f), x);
  const Real normal = select(finite < Real(1.17549435e-38f), Real(1.17549435e-38f), finite);
  // normal = m 2^e with m in [√½, √2), so that the polynomial is exact at 1 and has no seam there.
  const integer bits = bits_of(normal) - integer(0x3f3504f3);
  const Real exponent = to_float(bits >> 23);
  const Real t = float_of_bits((bits & integer(0x007fffff)) + integer(0x3f3504f3)) - Real(1.0f);
  Real p = Real(0.12583537f);
  p = p * t - Real(0.207268941f);
  p = p * t + Real(0.215715846f);
  p = p * t - Real(0.238944951f);
  p = p * t + Real(0.287916237f);
  p = p * t - Real(0.360703677f);
  p = p * t + Real(0.480910643f);
  p = p * t - Real(0.721347347f);
  p = p * t + Real(1.442695f);
  return select(x != x, x, exponent + p * t);
}

template <single_precision Real>
constexpr Real fast_exp2(Real x) noexcept {
  using integer = integer_of<Real>;
  const Real capped = select(x > Real(128.0f), Real(128.0f), x);
  const Real clamped = select(capped < Real(-126.0f), Real(-254.0f), capped);  // -254 gives 0, 128 infinity
  const integer whole =
      to_integer(select(clamped > Real(-254.0f), clamped, Real(-254.0f)) + Real(126.5f)) - integer(126);
  const Real t = clamped - to_float(whole);
  Real p = Real(0.000154697305f);
  p = p * t + Real(0.00133908669f);
  p = p * t + Real(0.00961803079f);
  p = p * t + Real(0.0555035711f);
  p = p * t + Real(0.240226511f);
  p = p * t + Real(0.693147188f);
  p = p * t + Real(1.0f);
  // 2^whole in two factors: 2^128 alone would overflow where the result does not.
  const integer part = whole >> 1;
  const Real first = float_of_bits((part + integer(127)) << 23);
  const Real second = float_of_bits((whole - part + integer(127)) << 23);
  return select(x != x, x, p * first * second);
}

template <single_precision Real>
constexpr Real power_of_cosine(Real x, Real y) noexcept {
  const Real least_normal = Real(1.17549435e-38f);
  Real power = Real(0.0f);
  if (holds_for_any(x >= least_normal)) {
    power = select(x >= least_normal, fast_exp2(y * fast_log2(x)), power);
  }
  return select(y < least_normal, Real(1.0f), power);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
