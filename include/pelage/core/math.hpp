// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/real_number.hpp>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace pelage {

/// x².
template <std::floating_point Real>
[[nodiscard]] constexpr Real sqr(Real x) noexcept;

/// √x, and 0 where x is negative or NaN: the guard for 1 - sin² that rounding made negative. Denormals, which a GPU
/// may flush, count as 0.
template <std::floating_point Real>
[[nodiscard]] Real safe_sqrt(Real x) noexcept;

/// x clamped to [0, 1]; NaN gives 0.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline constexpr Real saturate(Real x) noexcept;

/// The sum of two, clamped to 2³² - 1. Associative and commutative.
[[nodiscard]] constexpr std::uint32_t add_saturating(std::uint32_t a, std::uint32_t b) noexcept;

/// log₂ x from + − × alone, so that every machine agrees on its bits. For normal x > 0 within
/// 1e-7 · max(1, |log₂ x|). Zero, denormals and negatives give -126, the least exponent; NaN gives NaN, +inf 128.
[[nodiscard]] constexpr float fast_log2(float x) noexcept;

/// 2ˣ from + − × alone, relative error below 1e-7 for x in [-126, 128). Below: 0. From 128 on: +inf. NaN gives NaN.
[[nodiscard]] constexpr float fast_exp2(float x) noexcept;

/// xʸ for a base in [0, 1] and an exponent in [0, inf), as a highlight's lobe needs it: 0⁰ is 1, 0ʸ is 0. Relative
/// error below 2e-7 · (1 + y |log₂ x|) where the result is normal; smaller results are 0. A base that is denormal,
/// negative or NaN counts as 0, and so does an exponent that is denormal or negative.
[[nodiscard]] constexpr float power_of_cosine(float x, float y) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
constexpr Real sqr(Real x) noexcept {
  return x * x;
}

template <std::floating_point Real>
Real safe_sqrt(Real x) noexcept {
  return x >= std::numeric_limits<Real>::min() ? std::sqrt(x) : Real(0);
}

template <real_number Real>
constexpr Real saturate(Real x) noexcept {
  return select(x > Real(0), select(x < Real(1), x, Real(1)), Real(0));
}

constexpr std::uint32_t add_saturating(std::uint32_t a, std::uint32_t b) noexcept {
  const std::uint32_t room = 0xffffffffu - a;
  return a + (b < room ? b : room);
}

constexpr float fast_log2(float x) noexcept {
  if (x != x) {
    return x;
  }
  if (x < 1.17549435e-38f) {
    return -126.0f;
  }
  if (x > 3.40282347e38f) {
    return 128.0f;
  }
  // x = m 2^e with m in [√½, √2), so that the polynomial is exact at 1 and has no seam there.
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(x) - 0x3f3504f3u;
  const int exponent = (std::bit_cast<int>(bits) >> 23);
  const float t = std::bit_cast<float>((bits & 0x007fffffu) + 0x3f3504f3u) - 1.0f;
  float p = 0.12583537f;
  p = p * t - 0.207268941f;
  p = p * t + 0.215715846f;
  p = p * t - 0.238944951f;
  p = p * t + 0.287916237f;
  p = p * t - 0.360703677f;
  p = p * t + 0.480910643f;
  p = p * t - 0.721347347f;
  p = p * t + 1.442695f;
  return static_cast<float>(exponent) + p * t;
}

constexpr float fast_exp2(float x) noexcept {
  if (x != x) {
    return x;
  }
  if (x < -126.0f) {
    return 0.0f;
  }
  if (x >= 128.0f) {
    return std::bit_cast<float>(0x7f800000u);
  }
  const int whole = static_cast<int>(x + 126.5f) - 126;
  const float t = x - static_cast<float>(whole);
  float p = 0.000154697305f;
  p = p * t + 0.00133908669f;
  p = p * t + 0.00961803079f;
  p = p * t + 0.0555035711f;
  p = p * t + 0.240226511f;
  p = p * t + 0.693147188f;
  p = p * t + 1.0f;
  // 2^whole in two factors: 2^128 alone would overflow where the result does not.
  const int part = whole / 2;
  const float first = std::bit_cast<float>(static_cast<std::uint32_t>(part + 127) << 23u);
  const float second = std::bit_cast<float>(static_cast<std::uint32_t>(whole - part + 127) << 23u);
  return p * first * second;
}

constexpr float power_of_cosine(float x, float y) noexcept {
  if (y < 1.17549435e-38f) {
    return 1.0f;
  }
  if (!(x >= 1.17549435e-38f)) {
    return 0.0f;
  }
  return fast_exp2(y * fast_log2(x));
}

}  // namespace pelage
