// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lane_group.hpp>

#include <algorithm>
#include <cstdint>

/// Sorting across the W lanes of a group, one value a lane, by Batcher's bitonic network [Batcher 1968]: the same
/// shuffles and no branch whatever the data. Not stable. All lanes call each function together.
namespace pelage::inline PELAGE_ABI {

/// A fragment with its depth's key, and where the caller has the rest of it.
struct placed_fragment {
  std::uint32_t key;    ///< depth_key() of its depth; all ones for no fragment
  std::uint32_t id;     ///< the fragment's
  std::uint32_t place;  ///< any number; it takes no part in the order
};

/// Stands for none: behind every fragment.
[[nodiscard]] constexpr placed_fragment no_placed_fragment() noexcept {
  return placed_fragment{0xffffffffu, 0xffffffffu, 0xffffffffu};
}

/// The total order of fragments.
[[nodiscard]] constexpr bool placed_before(placed_fragment a, placed_fragment b) noexcept {
  return a.key == b.key ? a.id < b.id : a.key < b.key;
}

/// Lane l gets the l-th of the lanes' numbers, least first. log W (log W + 1) / 2 shuffles.
template <lane_group Group>
[[nodiscard]] std::uint32_t sort_lanes(const Group& group, std::uint32_t mine) noexcept;

/// Lane l gets the l-th of the lanes' fragments, nearest first. Three times as many shuffles.
template <lane_group Group>
[[nodiscard]] placed_fragment sort_lanes(const Group& group, placed_fragment mine) noexcept;

/// The same within each block of lanes that holds a bitonic sequence, one that rises and then falls or the other way
/// round: every other block nearest first, those between farthest first; a block of all lanes is nearest first.
/// `block`: a power of two, [2, W]. 3 log block shuffles.
template <lane_group Group>
[[nodiscard]] placed_fragment sort_bitonic(const Group& group, placed_fragment mine, std::uint32_t block) noexcept;

/// True for the lane of a pair that gets what comes first, in the step of such a block that pairs lanes `stride` apart.
template <lane_group Group>
[[nodiscard]] bool gets_first(const Group& group, std::uint32_t block, std::uint32_t stride) noexcept {
  return (group.lane() & stride) * block == (group.lane() & block) * stride;  // both bits are set, or none
}

/// What the lane numbered `from` holds.
template <lane_group Group>
[[nodiscard]] placed_fragment shuffle(const Group& group, placed_fragment mine, std::uint32_t from) noexcept {
  return placed_fragment{group.shuffle(mine.key, from), group.shuffle(mine.id, from), group.shuffle(mine.place, from)};
}

// ---------------------------------------------------------------------------------------------------------

template <lane_group Group>
std::uint32_t sort_lanes(const Group& group, std::uint32_t mine) noexcept {
  std::uint32_t sorted = mine;
  for (std::uint32_t block = 2u; block <= group.size(); block *= 2u) {
    for (std::uint32_t stride = block / 2u; stride > 0u; stride /= 2u) {
      const std::uint32_t other = group.shuffle_xor(sorted, stride);
      sorted = gets_first(group, block, stride) ? std::min(sorted, other) : std::max(sorted, other);
    }
  }
  return sorted;
}

template <lane_group Group>
placed_fragment sort_lanes(const Group& group, placed_fragment mine) noexcept {
  placed_fragment sorted = mine;
  for (std::uint32_t block = 2u; block <= group.size(); block *= 2u) {
    sorted = sort_bitonic(group, sorted, block);
  }
  return sorted;
}

template <lane_group Group>
placed_fragment sort_bitonic(const Group& group, placed_fragment mine, std::uint32_t block) noexcept {
  placed_fragment sorted = mine;
  for (std::uint32_t stride = block / 2u; stride > 0u; stride /= 2u) {
    const placed_fragment other =
        placed_fragment{group.shuffle_xor(sorted.key, stride), group.shuffle_xor(sorted.id, stride),
                        group.shuffle_xor(sorted.place, stride)};
    const bool is_other = other.key != sorted.key || other.id != sorted.id;  // else each lane keeps its own
    const bool swap = is_other && placed_before(other, sorted) == gets_first(group, block, stride);
    sorted = swap ? other : sorted;
  }
  return sorted;
}

}  // namespace pelage
