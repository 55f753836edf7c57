// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/tail.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/lane_moves.hpp>
#include <pelage/core/lanes.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// add_fragment() for W fragments at once, on the CPU: the fragment of each lane whose bit is set goes to the tail
/// behind[tail_of[k]]. The same tails, bit for bit, NaN included. set: [0, 2^W); tail_of[k]: [0, behind.size()) where
/// lane k is set, else any number; one tail may stand there many times. O(W).
template <int W>
[[gnu::always_inline]] inline void add_fragments(lanes<W> alpha, const lane_vector<W>& colour, std::uint32_t set,
                                                 const std::array<std::uint32_t, std::size_t{W}>& tail_of,
                                                 std::span<tail> behind) noexcept {
  static_assert(offsetof(tail, blue) == 4 * sizeof(std::uint32_t) && sizeof(tail) == 5 * sizeof(std::uint32_t));
  using floats = lanes<W>;
  const floats held = saturate(alpha);
  const lane_vector<W> kept = clamp_keeping_hue(colour);
  alignas(64) float words[4 * W];
  store_quads(bits_as<floats>(optical_depth(held)), bits_as<floats>(to_fixed(held)),
              bits_as<floats>(to_fixed(held * kept.x)), bits_as<floats>(to_fixed(held * kept.y)), words);
  const lanes<W, std::uint32_t> blue = to_fixed(held * kept.z);
  for (std::uint32_t left = set; left != 0u; left &= left - 1u) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    tail& t = behind[tail_of[k]];
    lanes<4, std::uint32_t> sum, one;  // all members but blue
    __builtin_memcpy(&one.lane, words + 4u * k, sizeof(one.lane));
    __builtin_memcpy(&sum.lane, &t, sizeof(sum.lane));
    sum = add_saturating(sum, one);
    __builtin_memcpy(&t, &sum.lane, sizeof(sum.lane));
    t.blue = add_saturating(t.blue, blue.lane[k]);
  }
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
