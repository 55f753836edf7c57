// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/tail.hpp>
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// The words of a pixel in atomic_tail: the five sums of a tail, and one bit a sum that went beyond 2^32.
[[nodiscard]] constexpr std::uint32_t tail_words() noexcept {
  return 6u;
}

/// A tail (composite/tail.hpp) a pixel, to which many threads add at once: for what falls out of an atomic_k_buffer.
///
/// Holds the same five sums, bit for bit, whatever the interleaving: atomic additions that mark where they pass the end
/// of the range (add_and_mark) suffice where tail's own need a saturating one. 24 bytes a pixel: cells
/// [pixel · tail_words(), (pixel + 1) · tail_words()), all 0 at first.
namespace atomic_tail {

/// Adds one fragment's tail, as add_fragment(empty_tail(), alpha, colour) makes it. `pixel`: [0, size() / 6).
/// Wait-free where the hardware adds atomically; O(1): an atomic a sum, one more where it passes 2^32, none where it
/// gains nothing. Memory orders: (1) and (2) of add_and_mark().
template <cell_storage Storage>
void add(Storage& storage, std::uint32_t pixel, const tail& one) noexcept {
  PELAGE_ASSERT(pixel < storage.size() / tail_words());
  const std::uint32_t first = pixel * tail_words();
  add_and_mark(storage, first, one.optical, first + 5u, 1u);
  add_and_mark(storage, first + 1u, one.weight, first + 5u, 2u);
  add_and_mark(storage, first + 2u, one.red, first + 5u, 4u);
  add_and_mark(storage, first + 3u, one.green, first + 5u, 8u);
  add_and_mark(storage, first + 4u, one.blue, first + 5u, 16u);
}

/// The tail that merge() gives for all that was added. Not concurrent with add: (3) of load_marked().
template <cell_storage Storage>
[[nodiscard]] tail load(const Storage& storage, std::uint32_t pixel) noexcept {
  PELAGE_ASSERT(pixel < storage.size() / tail_words());
  const std::uint32_t first = pixel * tail_words();
  return tail{load_marked(storage, first, first + 5u, 1u), load_marked(storage, first + 1u, first + 5u, 2u),
              load_marked(storage, first + 2u, first + 5u, 4u), load_marked(storage, first + 3u, first + 5u, 8u),
              load_marked(storage, first + 4u, first + 5u, 16u)};
}

}  // namespace atomic_tail

}  // namespace pelage
