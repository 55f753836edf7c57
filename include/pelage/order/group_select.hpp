// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/lane_group.hpp>
#include <pelage/order/lane_sort.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// The K nearest fragments of a pixel, kept by all W lanes of a group together: a K-buffer with a slot a lane, sorted
/// at all times. `Rows`: slots of a lane; K is in [1, Rows · W].
///
/// Each lane has an object of its own. All lanes call every function but clear(), offer_depth() and is_behind()
/// together, with the same k and the same slot. Each fragment is offered once in each of two passes, to any lane. The
/// first may be left out: it does not change the result, which depends on the set of fragments alone, but the K-th
/// least of the lanes' least depths bounds the K nearest, and few lie within it (at K = W / 2 about 1.4 K of however
/// many). In the second, fragments within the bound are gathered until there is one for each lane, sorted and merged
/// with the slots, of which slot K - 1 is the bound from then on.
///
/// Ties in depth go to the smaller id; of fragments equal in both any may be kept, each once, and `bound` may have
/// another one's place. What is_fragment() refuses is left out. A fragment costs O(1), a merge of W of them
/// O((Rows + log W) log W) shuffles. 12 Rows + 24 bytes a lane, in registers where k and Rows are constants, and the
/// words [0, 6 W) of the group.
template <std::uint32_t Rows>
struct group_select {
  std::array<placed_fragment, Rows> slot;  ///< row r of lane l is slot r · W + l, nearest first; valid after finish()
  placed_fragment bound;                   ///< what is not before it need not be held; after finish() as slot K - 1
  std::uint32_t k;                         ///< K; what stands in later slots means nothing
  std::uint32_t waiting;                   ///< fragments gathered and not yet in the slots, [0, W)
  std::uint32_t least;                     ///< of the depth keys that this lane was offered, all ones before

  /// Holds nothing from now on. `k_nearest`: K. In place, so that in a shader Rows may be a specialization constant.
  constexpr void clear(std::uint32_t k_nearest) noexcept;

  /// First pass: notes the depth of a fragment, which some lane must insert.
  constexpr void offer_depth(fragment offered) noexcept {
    least = is_fragment(offered) ? std::min(least, depth_key(offered.depth)) : least;
  }

  /// Ends the first pass. Does nothing where K > W / 2, where it would not pay; nor does it pay for W fragments or
  /// fewer.
  template <lane_group Group>
  void limit(const Group& group) noexcept;

  /// Second pass: takes one fragment from each lane, no_fragment() from a lane that has none.
  template <lane_group Group>
  void insert(Group& group, fragment offered, std::uint32_t place) noexcept;

  /// Ends the second pass: merges what waits.
  template <lane_group Group>
  void finish(Group& group) noexcept;

  /// Fragments held after finish(), [0, K].
  template <lane_group Group>
  [[nodiscard]] std::uint32_t held(const Group& group) const noexcept;

  /// The fragment in slot i after finish(), for every lane; no_placed_fragment() from held() on. `i`: [0, K).
  template <lane_group Group>
  [[nodiscard]] placed_fragment at(const Group& group, std::uint32_t i) const noexcept;

  /// After finish(): true for a fragment behind the last of K slots. That is every one which is not held where ids are
  /// unique; one equal to the last and not held is not behind it. False for what is_fragment() refuses.
  [[nodiscard]] constexpr bool is_behind(fragment f) const noexcept {
    return is_fragment(f) && placed_before(bound, placed_fragment{depth_key(f.depth), f.id, 0u});
  }

  /// Moves the last of what waits into the slots, one for each lane as far as there are.
  template <lane_group Group>
  void merge(Group& group) noexcept;
};

// ---------------------------------------------------------------------------------------------------------

template <std::uint32_t Rows>
constexpr void group_select<Rows>::clear(std::uint32_t k_nearest) noexcept {
  for (std::uint32_t row = 0u; row < Rows; ++row) {
    slot[row] = no_placed_fragment();
  }
  bound = no_placed_fragment();
  k = k_nearest;
  waiting = 0u;
  least = 0xffffffffu;
}

template <std::uint32_t Rows>
template <lane_group Group>
void group_select<Rows>::limit(const Group& group) noexcept {
  if (2u * k <= group.size()) {
    bound.key = group.shuffle(sort_lanes(group, least), k - 1u);
  }
}

template <std::uint32_t Rows>
template <lane_group Group>
void group_select<Rows>::insert(Group& group, fragment offered, std::uint32_t place) noexcept {
  PELAGE_ASSERT(k >= 1u && k <= Rows * group.size());
  const placed_fragment mine = placed_fragment{depth_key(offered.depth), offered.id, place};
  const bool is_near = is_fragment(offered) && placed_before(mine, bound);
  const lane_count near = group.count(is_near);
  const std::uint32_t word = 3u * (waiting + near.below);
  if (is_near) {
    group.store(word, mine.key);
    group.store(word + 1u, mine.id);
    group.store(word + 2u, mine.place);
  }
  waiting += near.all;
  if (waiting >= group.size()) {
    merge(group);
  }
}

template <std::uint32_t Rows>
template <lane_group Group>
void group_select<Rows>::finish(Group& group) noexcept {
  if (waiting > 0u) {
    merge(group);
  }
}

template <std::uint32_t Rows>
template <lane_group Group>
void group_select<Rows>::merge(Group& group) noexcept {
  const std::uint32_t taken = std::min(waiting, group.size());
  waiting -= taken;
  group.barrier();
  const std::uint32_t word = 3u * (waiting + std::min(group.lane(), taken - 1u));
  const placed_fragment gathered = placed_fragment{group.load(word), group.load(word + 1u), group.load(word + 2u)};
  group.barrier();
  placed_fragment carried = sort_lanes(group, group.lane() < taken ? gathered : no_placed_fragment());
  for (std::uint32_t row = 0u; row < Rows; ++row) {
    const placed_fragment other = shuffle(group, carried, group.size() - 1u - group.lane());
    const placed_fragment mine = slot[row];
    const bool swap = placed_before(other, mine);
    const placed_fragment near = swap ? other : mine;
    const placed_fragment far = swap ? mine : other;
    slot[row] = sort_bitonic(group, near, group.size());
    carried = sort_bitonic(group, far, group.size());
  }
  const placed_fragment last = at(group, k - 1u);
  bound = placed_before(last, bound) ? last : bound;
}

template <std::uint32_t Rows>
template <lane_group Group>
std::uint32_t group_select<Rows>::held(const Group& group) const noexcept {
  std::uint32_t count = 0u;
  for (std::uint32_t row = 0u; row < Rows; ++row) {
    count += group.count(slot[row].key != 0xffffffffu).all;
  }
  return std::min(count, k);
}

template <std::uint32_t Rows>
template <lane_group Group>
placed_fragment group_select<Rows>::at(const Group& group, std::uint32_t i) const noexcept {
  placed_fragment found = no_placed_fragment();
  for (std::uint32_t row = 0u; row < Rows; ++row) {
    const placed_fragment there = shuffle(group, slot[row], i % group.size());
    found = row == i / group.size() ? there : found;
  }
  return found;
}

}  // namespace pelage
