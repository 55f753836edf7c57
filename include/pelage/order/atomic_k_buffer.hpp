// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/order/packed_fragment.hpp>
#include <pelage/order/sorting_network.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>

/// The K fragments of each pixel nearest the eye, built by many threads in one pass and fixed memory: a K-buffer whose
/// slots are exchanged.
///
/// Keeps the K first of the total order; drops nothing silently, since insert() hands back what falls out, for the
/// caller's tail (composite/atomic_tail.hpp). Once all inserts are done, what load() gives and the set of what fell
/// out depend on the set of fragments alone. Build and read are two phases, as with a_buffer. 8 K bytes a pixel: cells
/// [pixel · K, (pixel + 1) · K), all pack(no_fragment()) at first; no pool, so nothing can fill up. K in [1, 64].
///
/// For CPU threads; on a GPU cascade_k_buffer is faster, and the more so the larger K is.
///
/// The first K - 1 slots, in no order, are select-and-replace as in a k_buffer; what they do not hold goes on to the
/// last slot, a minimum, which so holds the K-th nearest: a fragment behind it comes back after one load.
///
/// Proof. (a) Nothing is lost or doubled: each exchange and each minimum leaves one of two values in the slot and
/// carries the other on, and it is atomic. (b) A value that goes on to the last slot is larger than each slot before
/// it will hold in the end: slots only fall, and the slot that it comes from was given something smaller; every other
/// one was seen to hold something smaller. (c) So when all inserts are done, the first K - 1 slots hold the K - 1
/// smallest, the last slot the smallest of all others, and the rest fell out. A value larger than what was seen in the
/// last slot is larger than what went there, hence by (b) than all slots: it would have fallen out. Which thread came
/// first, and in which order steps on different slots became visible, does not enter.
namespace pelage::inline PELAGE_ABI::atomic_k_buffer {

/// Offers a fragment. Returns what fell out: a fragment that others pushed out, itself where K nearer ones are held,
/// or no_fragment(). What is_fragment() refuses comes back as it is. Depths -0 come back as +0. Over all inserts of
/// a pixel, what comes back is each fragment that is not among the K nearest, once; which call it comes back from
/// depends on the interleaving. For a tail, look up alpha and colour by the id that comes back.
///
/// `pixel`: [0, size() / K). Lock-free: a step is repeated only because another insert made the same slot smaller. One
/// load for a fragment that is too far; K loads, an exchange and a minimum at most for one that stays.
///
/// (1) and (2) are relaxed: a stale value is one that the slot held before, hence no smaller, and leads to a step that
/// could have been spared, or to an exchange (3) that fails. (3) and (4) are relaxed: a slot holds all there is to
/// know, and publishes nothing else.
template <std::uint32_t K, exchanged_cells<std::uint64_t> Storage>
[[nodiscard]] fragment insert(Storage& storage, std::uint32_t pixel, fragment offered) noexcept;

/// The K nearest fragments of a pixel, nearest first, no_fragment() behind the last. Not concurrent with insert: (5) is
/// relaxed, the barrier between the phases orders it after every (3) and (4). `pixel` as above. O(K log² K).
template <std::uint32_t K, exchanged_cells<std::uint64_t> Storage>
[[nodiscard]] std::array<fragment, K> load(const Storage& storage, std::uint32_t pixel) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::uint32_t K, exchanged_cells<std::uint64_t> Storage>
fragment insert(Storage& storage, std::uint32_t pixel, fragment offered) noexcept {
  static_assert(K >= 1u && K <= 64u, "pelage::atomic_k_buffer: K must be in [1, 64]");
  PELAGE_ASSERT(pixel < storage.size() / K);
  if (!is_fragment(offered)) {
    return offered;
  }
  const std::uint32_t first = pixel * K;
  const std::uint32_t last = first + K - 1u;
  std::uint64_t carried = pack(offered);
  if (storage.load(last, std::memory_order_relaxed) < carried) {  // (1)
    return unpack(carried);
  }
  bool placed = false;
  while (!placed) {
    std::uint64_t farthest = carried;
    std::uint32_t place = last;
    for (std::uint32_t i = first; i < last; ++i) {
      const std::uint64_t seen = storage.load(i, std::memory_order_relaxed);  // (2)
      const bool farther = farthest < seen;
      farthest = farther ? seen : farthest;
      place = farther ? i : place;
    }
    placed = place == last;
    if (!placed) {
      const std::uint64_t found = storage.compare_exchange(place, farthest, carried, std::memory_order_relaxed);  // (3)
      placed = found == farthest;
      carried = placed ? farthest : carried;
    }
  }
  if (carried != pack(no_fragment())) {
    const std::uint64_t held = storage.fetch_min(last, carried, std::memory_order_relaxed);  // (4)
    carried = std::max(held, carried);
  }
  return unpack(carried);
}

template <std::uint32_t K, exchanged_cells<std::uint64_t> Storage>
std::array<fragment, K> load(const Storage& storage, std::uint32_t pixel) noexcept {
  PELAGE_ASSERT(pixel < storage.size() / K);
  std::array<fragment, K> nearest;
  for (std::uint32_t i = 0u; i < K; ++i) {
    nearest[i] = unpack(storage.load(pixel * K + i, std::memory_order_relaxed));  // (5)
  }
  sort_network<K>(nearest);
  return nearest;
}

}  // namespace pelage::atomic_k_buffer
