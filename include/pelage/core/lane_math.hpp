// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lanes.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/vector_math.hpp>

#include <glm/vec3.hpp>

#include <limits>

namespace pelage {

/// Functions of core/math.hpp that work on a float's bits, for W floats at once, on the CPU alone: each lane has the
/// bits that the scalar function gives, and its contract.

/// W points or directions.
template <int W>
using lane_vector = glm::vec<3, lanes<W>, glm::defaultp>;

template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> fast_log2(lanes<W> x) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> fast_exp2(lanes<W> x) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> power_of_cosine(lanes<W> x, lanes<W> y) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <int W>
lanes<W> fast_log2(lanes<W> x) noexcept {
  using integers = typename lanes<W>::integers;
  using vector = typename lanes<W>::vector;
  const lanes<W> least_normal(1.17549435e-38f);
  const lanes<W> greatest(3.40282347e38f);
  const lanes<W> held = select(x < least_normal, least_normal, select(x < greatest, x, greatest));
  const integers bits = reinterpret_cast<integers>(held.lane) - 0x3f3504f3;
  const lanes<W> exponent(__builtin_convertvector(bits >> 23, vector));
  const lanes<W> t = lanes<W>(reinterpret_cast<vector>((bits & 0x007fffff) + 0x3f3504f3)) - lanes<W>(1.0f);
  lanes<W> p(0.12583537f);
  p = p * t - lanes<W>(0.207268941f);
  p = p * t + lanes<W>(0.215715846f);
  p = p * t - lanes<W>(0.238944951f);
  p = p * t + lanes<W>(0.287916237f);
  p = p * t - lanes<W>(0.360703677f);
  p = p * t + lanes<W>(0.480910643f);
  p = p * t - lanes<W>(0.721347347f);
  p = p * t + lanes<W>(1.442695f);
  const lanes<W> inside = exponent + p * t;
  const lanes<W> bounded = select(x < least_normal, lanes<W>(-126.0f), select(x > greatest, lanes<W>(128.0f), inside));
  return select(lane_mask<W>{x.lane != x.lane}, x, bounded);
}

template <int W>
lanes<W> fast_exp2(lanes<W> x) noexcept {
  using integers = typename lanes<W>::integers;
  using vector = typename lanes<W>::vector;
  const lanes<W> least(-126.0f);
  const lanes<W> end(128.0f);
  const lanes<W> held = select(x < least, least, select(x < end, x, lanes<W>(0.0f)));
  const integers whole = __builtin_convertvector((held + lanes<W>(126.5f)).lane, integers) - 126;
  const lanes<W> t = held - lanes<W>(__builtin_convertvector(whole, vector));
  lanes<W> p(0.000154697305f);
  p = p * t + lanes<W>(0.00133908669f);
  p = p * t + lanes<W>(0.00961803079f);
  p = p * t + lanes<W>(0.0555035711f);
  p = p * t + lanes<W>(0.240226511f);
  p = p * t + lanes<W>(0.693147188f);
  p = p * t + lanes<W>(1.0f);
  const integers part = whole >> 1;
  const lanes<W> first(reinterpret_cast<vector>((part + 127) << 23));
  const lanes<W> second(reinterpret_cast<vector>((whole - part + 127) << 23));
  const lanes<W> infinity(std::numeric_limits<float>::infinity());
  const lanes<W> bounded = select(x < end, p * first * second, x + infinity);  // of a NaN, NaN
  return select(x < least, lanes<W>(0.0f), bounded);
}

template <int W>
lanes<W> power_of_cosine(lanes<W> x, lanes<W> y) noexcept {
  const lanes<W> least_normal(1.17549435e-38f);
  const lanes<W> power = select(x < least_normal, lanes<W>(0.0f), fast_exp2(y * fast_log2(x)));
  const lanes<W> of_number = select(lane_mask<W>{x.lane != x.lane}, lanes<W>(0.0f), power);
  return select(y < least_normal, lanes<W>(1.0f), of_number);
}

}  // namespace pelage
