// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/order/packed_fragment.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>

/// The K fragments of each pixel nearest the eye, sorted, built by many threads in one pass and fixed memory: a
/// cascade of atomic minima.
///
/// Keeps the K first of the total order; drops nothing silently, since insert() hands back what falls out, for the
/// caller's tail (composite/atomic_tail.hpp). Once all inserts are done, the slots and the set of what fell out
/// depend on the set of fragments alone. Build and read are two phases, as with a_buffer. 8 K bytes a pixel: cells
/// [pixel · K, (pixel + 1) · K), all pack(no_fragment()) at first; no pool, so nothing can fill up. K in [1, 64].
///
/// Proof. (a) Nothing is lost or doubled: each minimum leaves one of two values in the slot and carries the other on,
/// and it is atomic. (b) A value that has passed a slot is larger than what the slot holds from then on: the minimum
/// left something smaller there, and slots only fall. So when all inserts are done, each slot holds less than the
/// slots behind it, since those values passed it, and less than all that fell out: the slots hold the K smallest, in
/// order. Which thread came first, and in which order steps on different slots became visible, does not enter.
///
/// For devices: a cascade's loads and minima do not wait for each other as an exchange waits for what it compares
/// (measured in bench/frame/README.md); CPU threads have atomic_k_buffer, which touches two slots an insert.
///
/// A value may also pass a slot without a minimum, if that slot or one behind it was seen to hold less: what was seen
/// there has passed the slot itself, so (b) holds again.
namespace pelage::inline PELAGE_ABI::cascade_k_buffer {

/// Offers a fragment. Returns what fell out: a fragment that others pushed on, itself where K nearer ones are held,
/// or no_fragment(). What is_fragment() refuses comes back as it is. Depths -0 come back as +0. Over all inserts of
/// a pixel, what comes back is each fragment that is not among the K nearest, once; which call it comes back from
/// depends on the interleaving. For a tail, look up alpha and colour by the id that comes back.
///
/// `pixel`: [0, size() / K). Wait-free where the minimum of the hardware is, else lock-free: a step is
/// repeated only because another insert made the same slot smaller. O(log K) loads for a fragment that is too far or
/// finds its place at the end, K - i minima for one that finds it at slot i.
///
/// (1) and (2) are relaxed: a stale value is one that the slot held before, hence no smaller, and only leads to a
/// step that could have been spared. (3) is relaxed: the slot holds all there is to know, and publishes nothing else.
template <std::uint32_t K, falling_cells<std::uint64_t> Storage>
[[nodiscard]] fragment insert(Storage& storage, std::uint32_t pixel, fragment offered) noexcept {
  static_assert(K >= 1u && K <= 64u, "pelage::cascade_k_buffer: K must be in [1, 64]");
  PELAGE_ASSERT(pixel < storage.size() / K);
  if (!is_fragment(offered)) {
    return offered;
  }
  const std::uint32_t first = pixel * K;
  std::uint64_t carried = pack(offered);
  if (storage.load(first + K - 1u, std::memory_order_relaxed) < carried) {  // (1)
    return unpack(carried);
  }
  std::uint32_t begin = 0u;
  std::uint32_t end = K - 1u;
  while (begin < end) {
    const std::uint32_t middle = (begin + end) / 2u;
    if (storage.load(first + middle, std::memory_order_relaxed) < carried) {  // (2)
      begin = middle + 1u;
    } else {
      end = middle;
    }
  }
  for (std::uint32_t i = begin; i < K && carried != pack(no_fragment()); ++i) {
    const std::uint64_t held = storage.fetch_min(first + i, carried, std::memory_order_relaxed);  // (3)
    carried = std::max(held, carried);
  }
  return unpack(carried);
}

/// The i-th nearest fragment of a pixel, or no_fragment() behind the last. `i`: [0, K). Not concurrent with insert:
/// (4) is relaxed, the barrier between the phases orders it after every (3).
template <std::uint32_t K, falling_cells<std::uint64_t> Storage>
[[nodiscard]] fragment at(const Storage& storage, std::uint32_t pixel, std::uint32_t i) noexcept {
  PELAGE_ASSERT(pixel < storage.size() / K && i < K);
  return unpack(storage.load(pixel * K + i, std::memory_order_relaxed));  // (4)
}

}  // namespace pelage::cascade_k_buffer
