// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/fragment.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>

/// atomic_k_buffer for hardware without 64-bit atomics: its words split in two of 32 bits, the depths in a first pass
/// and the ids in a second one. Not the two-pass algorithm of [Yu12 §5.1], which is an a_buffer and then a k_buffer
/// that reads it.
///
/// Keeps the same K fragments in the same order, ties by id included; hands back what falls out in the second pass.
/// Each fragment is offered once in each pass. Between the passes, and between the second one and the first read, the
/// caller joins its threads, or waits at a barrier that synchronises them. 8 K bytes a pixel: cells
/// [2 K · pixel, 2 K · (pixel + 1)), depth keys and then as many ids, all ones at first. K in [1, 64].
///
/// The first pass is a cascade of atomic minima on depth keys: each leaves the smaller of two values in a slot and
/// carries the other on to the next, so nothing is lost or doubled. What has passed a slot is no smaller than what the
/// slot holds from then on, since slots only fall: the cascade leaves the K smallest in order, equal ones with their
/// multiplicity. Then the slots of one depth are a run, and the second pass is the same cascade of ids along that run:
/// it leaves the run's smallest ids in order. Only a run that ends at slot K - 1 may have more fragments than slots;
/// its larger ids fall out. Which thread came first does not enter.
namespace pelage::inline PELAGE_ABI::split_k_buffer {

/// First pass: offers a fragment's depth. What is_fragment() refuses is left out. `pixel`: [0, size() / (2 K)).
/// Wait-free where the minimum of the hardware is, else lock-free. O(K).
///
/// (1) is relaxed: a stale value is one that the slot held before, hence no smaller, and only leads to steps that could
/// have been spared. (2) is relaxed: the slot holds all there is to know, and publishes nothing else.
template <std::uint32_t K, falling_cells<std::uint32_t> Storage>
void offer_depth(Storage& storage, std::uint32_t pixel, fragment offered) noexcept {
  static_assert(K >= 1u && K <= 64u, "pelage::split_k_buffer: K must be in [1, 64]");
  PELAGE_ASSERT(pixel < storage.size() / (2u * K));
  const std::uint32_t first = pixel * 2u * K;
  std::uint32_t carried = is_fragment(offered) ? depth_key(offered.depth) : 0xffffffffu;
  if (storage.load(first + K - 1u, std::memory_order_relaxed) <= carried) {  // (1)
    return;
  }
  for (std::uint32_t i = 0u; i < K && carried != 0xffffffffu; ++i) {
    const std::uint32_t held = storage.fetch_min(first + i, carried, std::memory_order_relaxed);  // (2)
    carried = std::max(held, carried);
  }
}

/// Second pass: offers the fragment itself. Returns what fell out: one of equal depth with a larger id, itself, or
/// no_fragment(). What is_fragment() refuses comes back as it is. Depths -0 come back as +0. `pixel` and progress as
/// in the first pass. O(K).
///
/// (3) relaxed: the barrier between the passes orders it after every (2). (4) relaxed: as (2), on ids.
template <std::uint32_t K, falling_cells<std::uint32_t> Storage>
[[nodiscard]] fragment insert(Storage& storage, std::uint32_t pixel, fragment offered) noexcept {
  PELAGE_ASSERT(pixel < storage.size() / (2u * K));
  if (!is_fragment(offered)) {
    return offered;
  }
  const std::uint32_t first = pixel * 2u * K;
  const std::uint32_t key = depth_key(offered.depth);
  std::uint32_t carried = offered.id;
  for (std::uint32_t i = 0u; i < K && carried != no_fragment().id; ++i) {
    if (storage.load(first + i, std::memory_order_relaxed) == key) {                                    // (3)
      const std::uint32_t held = storage.fetch_min(first + K + i, carried, std::memory_order_relaxed);  // (4)
      carried = std::max(held, carried);
    }
  }
  return carried != no_fragment().id ? fragment{depth_from_key(key), carried} : no_fragment();
}

/// The i-th nearest fragment of a pixel, or no_fragment() behind the last. `i`: [0, K). Not concurrent with either
/// pass: (5) is relaxed, the barrier orders it after every (4).
template <std::uint32_t K, falling_cells<std::uint32_t> Storage>
[[nodiscard]] fragment at(const Storage& storage, std::uint32_t pixel, std::uint32_t i) noexcept {
  PELAGE_ASSERT(pixel < storage.size() / (2u * K) && i < K);
  const std::uint32_t slot = pixel * 2u * K + i;
  const std::uint32_t id = storage.load(slot + K, std::memory_order_relaxed);  // (5)
  return id == no_fragment().id ? no_fragment()
                                : fragment{depth_from_key(storage.load(slot, std::memory_order_relaxed)), id};
}

}  // namespace pelage::split_k_buffer
