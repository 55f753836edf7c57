// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/optical_depth.hpp>
#include <pelage/core/lane_math.hpp>

#include <cstdint>

namespace pelage {

/// The functions of optical_depth.hpp for W fragments at once, on the CPU: each lane has the bits that the scalar
/// function gives.

/// W numbers, unsigned.
template <int W>
struct lane_numbers {
  typename lanes<W>::naturals lane;
};

/// optical_depth() of each lane.
template <int W>
[[nodiscard, gnu::always_inline]] inline lane_numbers<W> optical_depth(lanes<W> alpha) noexcept;

/// to_fixed() of each lane.
template <int W>
[[nodiscard, gnu::always_inline]] inline lane_numbers<W> to_fixed(lanes<W> x) noexcept;

/// add_saturating() of each pair of lanes.
template <int W>
[[nodiscard, gnu::always_inline]] inline lane_numbers<W> add_saturating(lane_numbers<W> a, lane_numbers<W> b) noexcept;

/// The sum of all lanes by add_saturating().
template <int W>
[[nodiscard, gnu::always_inline]] inline std::uint32_t sum_saturating(lane_numbers<W> x) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <int W>
lane_numbers<W> optical_depth(lanes<W> alpha) noexcept {
  const lanes<W> most(32.0f);
  const lanes<W> octaves = lanes<W>(0.0f) - fast_log2(lanes<W>(1.0f) - saturate(alpha));
  return to_fixed(select(octaves < most, octaves, most));
}

template <int W>
lane_numbers<W> to_fixed(lanes<W> x) noexcept {
  using naturals = typename lanes<W>::naturals;
  const lanes<W> zero(0.0f);
  const lanes<W> end(4096.0f);
  const lanes<W> units = select(x > zero, select(x < end, x, zero), zero) * lanes<W>(1048576.0f);
  const lanes<W> rounded = select(units < lanes<W>(8388608.0f), units + lanes<W>(0.5f), units);
  const naturals whole = __builtin_convertvector(rounded.lane, naturals);
  return lane_numbers<W>{x.lane >= end.lane ? naturals{} + 0xffffffffu : whole};
}

template <int W>
lane_numbers<W> add_saturating(lane_numbers<W> a, lane_numbers<W> b) noexcept {
  const auto room = ~a.lane;
  return lane_numbers<W>{a.lane + (b.lane < room ? b.lane : room)};
}

template <int W>
std::uint32_t sum_saturating(lane_numbers<W> x) noexcept {
  std::uint32_t sum = x.lane[0];
  for (int k = 1; k < W; ++k) {
    sum = add_saturating(sum, x.lane[k]);
  }
  return sum;
}

}  // namespace pelage
