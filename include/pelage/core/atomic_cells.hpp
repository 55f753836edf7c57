// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/math.hpp>

#include <atomic>
#include <concepts>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// Where numbers live that many threads lower at once: cells [0, size()), each reached by a call that names its memory
/// order, so that the same algorithm runs on std::atomic_ref, on a shader's buffer and on cells that a test watches.
/// fetch_min, as every fetch below, returns what the cell held before.
template <class Storage, class Word>
concept falling_cells = requires(Storage& s, const Storage& c, std::uint32_t n, Word value, std::memory_order order) {
  { c.size() } -> std::same_as<std::uint32_t>;
  { c.load(n, order) } -> std::same_as<Word>;
  { s.fetch_min(n, value, order) } -> std::same_as<Word>;
};

/// The same cells exchanged, too. A compare-exchange returns what it found; it took place exactly when that is the
/// second argument, and must not fail spuriously.
template <class Storage, class Word>
concept exchanged_cells = falling_cells<Storage, Word> &&
    requires(Storage& s, std::uint32_t n, Word value, std::memory_order order) {
  { s.compare_exchange(n, value, value, order) } -> std::same_as<Word>;
};

/// 32-bit cells that change in every way the structures need. fetch_add adds modulo 2³².
template <class Storage>
concept cell_storage = exchanged_cells<Storage, std::uint32_t> &&
    requires(Storage& s, std::uint32_t n, std::memory_order order) {
  { s.fetch_max(n, n, order) } -> std::same_as<std::uint32_t>;
  { s.fetch_or(n, n, order) } -> std::same_as<std::uint32_t>;
  { s.fetch_add(n, n, order) } -> std::same_as<std::uint32_t>;
};

/// Atomic minimum by compare-exchange, for cells that have none of their own (C++ brings one only in 2026). Returns
/// what the cell held before. Lock-free: an exchange fails only because another thread made the cell smaller. Where
/// the value is not smaller, it is a relaxed load and no more. In GLSL: atomicMin.
template <class Cell, class Value>
Value fetch_minimum(Cell&& cell, Value value, std::memory_order order) noexcept {
  Value held = cell.load(std::memory_order_relaxed);
  while (value < held && !cell.compare_exchange_strong(held, value, order, std::memory_order_relaxed)) {
  }
  return held;
}

/// The same for the maximum. In GLSL: atomicMax.
template <class Cell, class Value>
Value fetch_maximum(Cell&& cell, Value value, std::memory_order order) noexcept {
  Value held = cell.load(std::memory_order_relaxed);
  while (value > held && !cell.compare_exchange_strong(held, value, order, std::memory_order_relaxed)) {
  }
  return held;
}

/// Cells of 32 or 64 bits over the caller's memory, atomic through std::atomic_ref. Lock-free where that is. What a
/// cell holds before the first change is up to the structure that it belongs to.
template <class Word>
struct atomic_cells {
  std::span<Word> words;  ///< at most 2^32 - 1

  [[nodiscard]] std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(words.size()); }
  [[nodiscard]] Word load(std::uint32_t cell, std::memory_order order) const noexcept {
    return std::atomic_ref(words[cell]).load(order);
  }
  Word fetch_min(std::uint32_t cell, Word value, std::memory_order order) noexcept {
    return fetch_minimum(std::atomic_ref(words[cell]), value, order);
  }
  Word fetch_max(std::uint32_t cell, Word value, std::memory_order order) noexcept {
    return fetch_maximum(std::atomic_ref(words[cell]), value, order);
  }
  Word fetch_or(std::uint32_t cell, Word bits, std::memory_order order) noexcept {
    return std::atomic_ref(words[cell]).fetch_or(bits, order);
  }
  Word fetch_add(std::uint32_t cell, Word amount, std::memory_order order) noexcept {
    return std::atomic_ref(words[cell]).fetch_add(amount, order);
  }
  [[nodiscard]] Word compare_exchange(std::uint32_t cell, Word expected, Word desired,
                                      std::memory_order order) noexcept {
    std::atomic_ref(words[cell]).compare_exchange_strong(expected, desired, order, std::memory_order_relaxed);
    return expected;
  }
};

static_assert(cell_storage<atomic_cells<std::uint32_t>> && exchanged_cells<atomic_cells<std::uint64_t>, std::uint64_t>);

// The changes below commute, so that a cell ends with the same bits for every interleaving. All are lock-free, and
// wait-free except for add_to_cell() where the hardware has the change. All accesses are relaxed: a cell is a number
// that leads to nothing else, and no thread reads a structure while others build it; between the two phases the caller
// joins its threads, or waits at a barrier that synchronises them.

/// Sets bits. Costs no write where they are set already.
template <cell_storage Storage>
void set_bits(Storage& storage, std::uint32_t cell, std::uint32_t bits) noexcept {
  if ((storage.load(cell, std::memory_order_relaxed) & bits) != bits) {
    storage.fetch_or(cell, bits, std::memory_order_relaxed);
  }
}

/// Lowers a cell to a value, if that is less. Costs no write where it is not.
template <cell_storage Storage>
void lower_cell(Storage& storage, std::uint32_t cell, std::uint32_t value) noexcept {
  if (value < storage.load(cell, std::memory_order_relaxed)) {
    storage.fetch_min(cell, value, std::memory_order_relaxed);
  }
}

/// Raises a cell to a value, if that is more. Costs no write where it is not.
template <cell_storage Storage>
void raise_cell(Storage& storage, std::uint32_t cell, std::uint32_t value) noexcept {
  if (value > storage.load(cell, std::memory_order_relaxed)) {
    storage.fetch_max(cell, value, std::memory_order_relaxed);
  }
}

/// Adds to a cell and stops at 2³² - 1, which is still the same in any order; a plain fetch_add would wrap round.
template <cell_storage Storage>
void add_to_cell(Storage& storage, std::uint32_t cell, std::uint32_t amount) noexcept {
  std::uint32_t found = storage.load(cell, std::memory_order_relaxed);
  while (amount > 0u && found < 0xffffffffu) {
    const std::uint32_t expected = found;
    found = storage.compare_exchange(cell, expected, add_saturating(expected, amount), std::memory_order_relaxed);
    if (found == expected) {
      return;
    }
  }
}

/// Adds to a cell modulo 2³² and sets `bit` in the cell `ends` if that passes the end of the range: what
/// add_to_cell() does, for hardware that adds, at the price of a bit a sum. A sum modulo 2³² passes its end once for
/// every 2³² of the true sum, in whichever order the parts come; so whether one of the additions (1) saw it pass and
/// set the bit (2) says whether the sum saturates.
template <cell_storage Storage>
void add_and_mark(Storage& storage, std::uint32_t cell, std::uint32_t amount, std::uint32_t ends,
                  std::uint32_t bit) noexcept {
  if (amount != 0u) {
    const std::uint32_t held = storage.fetch_add(cell, amount, std::memory_order_relaxed);  // (1)
    if (held > 0xffffffffu - amount) {
      storage.fetch_or(ends, bit, std::memory_order_relaxed);  // (2)
    }
  }
}

/// What add_and_mark() left in a cell, saturated. Not concurrent with it: (3) is read behind the barrier.
template <cell_storage Storage>
[[nodiscard]] std::uint32_t load_marked(const Storage& storage, std::uint32_t cell, std::uint32_t ends,
                                        std::uint32_t bit) noexcept {
  const bool passed = (storage.load(ends, std::memory_order_relaxed) & bit) != 0u;  // (3)
  return passed ? 0xffffffffu : storage.load(cell, std::memory_order_relaxed);      // (3)
}

}  // namespace pelage
