// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <concepts>
#include <cstdint>
#include <span>

namespace pelage {

/// Where the cells of a map live: 32-bit numbers that many threads change at once, each reached by a call that names
/// its memory order, so that the same algorithm runs on std::atomic_ref, on a shader's buffers and on cells that a
/// test watches.
///
/// Cells are numbered [0, cell_count()). fetch_or_cell returns what it found, as does a compare-exchange; that
/// took place exactly when it found `expected`, and must not fail spuriously.
template <class Storage>
concept cell_storage = requires(Storage& s, const Storage& c, std::uint32_t n, std::memory_order order) {
  { c.cell_count() } -> std::same_as<std::uint32_t>;
  { c.load_cell(n, order) } -> std::same_as<std::uint32_t>;
  { s.fetch_or_cell(n, n, order) } -> std::same_as<std::uint32_t>;
  { s.compare_exchange_cell(n, n, n, order) } -> std::same_as<std::uint32_t>;
};

/// cell_storage over the caller's memory, atomic through std::atomic_ref. Lock-free where a 32-bit atomic_ref is.
/// What a cell holds before the first change is up to the map that it belongs to.
struct atomic_cell_storage {
  std::span<std::uint32_t> cells;  ///< at most 2^32 - 1

  [[nodiscard]] std::uint32_t cell_count() const noexcept { return static_cast<std::uint32_t>(cells.size()); }
  [[nodiscard]] std::uint32_t load_cell(std::uint32_t cell, std::memory_order order) const noexcept {
    return std::atomic_ref(cells[cell]).load(order);
  }
  std::uint32_t fetch_or_cell(std::uint32_t cell, std::uint32_t bits, std::memory_order order) noexcept {
    return std::atomic_ref(cells[cell]).fetch_or(bits, order);
  }
  [[nodiscard]] std::uint32_t compare_exchange_cell(std::uint32_t cell, std::uint32_t expected, std::uint32_t desired,
                                                    std::memory_order order) noexcept {
    std::atomic_ref(cells[cell]).compare_exchange_strong(expected, desired, order, std::memory_order_relaxed);
    return expected;
  }
};

static_assert(cell_storage<atomic_cell_storage>);

/// The sum of two amounts, held to 2³² - 1. Associative and commutative.
[[nodiscard]] constexpr std::uint32_t add_amounts(std::uint32_t a, std::uint32_t b) noexcept;

// The changes below commute, so that a cell ends with the same bits for every interleaving. All are lock-free: one
// turns again only because another change succeeded. All accesses are relaxed: a cell is a number that leads to
// nothing else, and no thread reads a map while others build it; between the two phases the caller joins its threads,
// or waits at a barrier that synchronises them.

/// Sets bits. Costs no write where they are set already.
template <cell_storage Storage>
void set_bits(Storage& storage, std::uint32_t cell, std::uint32_t bits) noexcept;

/// Lowers a cell to a value, if that is less.
template <cell_storage Storage>
void lower_cell(Storage& storage, std::uint32_t cell, std::uint32_t value) noexcept;

/// Raises a cell to a value, if that is more.
template <cell_storage Storage>
void raise_cell(Storage& storage, std::uint32_t cell, std::uint32_t value) noexcept;

/// Adds to a cell and stops at 2³² - 1, which is still the same in any order; a plain fetch_add would wrap round.
template <cell_storage Storage>
void add_to_cell(Storage& storage, std::uint32_t cell, std::uint32_t amount) noexcept;

// ---------------------------------------------------------------------------------------------------------

constexpr std::uint32_t add_amounts(std::uint32_t a, std::uint32_t b) noexcept {
  const std::uint32_t room = 0xffffffffu - a;
  return a + (b < room ? b : room);
}

template <cell_storage Storage>
void set_bits(Storage& storage, std::uint32_t cell, std::uint32_t bits) noexcept {
  const std::uint32_t found = storage.load_cell(cell, std::memory_order_relaxed);
  if ((found & bits) != bits) {
    storage.fetch_or_cell(cell, bits, std::memory_order_relaxed);
  }
}

template <cell_storage Storage>
void lower_cell(Storage& storage, std::uint32_t cell, std::uint32_t value) noexcept {
  std::uint32_t found = storage.load_cell(cell, std::memory_order_relaxed);
  while (value < found) {
    const std::uint32_t expected = found;
    found = storage.compare_exchange_cell(cell, expected, value, std::memory_order_relaxed);
    if (found == expected) {
      return;
    }
  }
}

template <cell_storage Storage>
void raise_cell(Storage& storage, std::uint32_t cell, std::uint32_t value) noexcept {
  std::uint32_t found = storage.load_cell(cell, std::memory_order_relaxed);
  while (value > found) {
    const std::uint32_t expected = found;
    found = storage.compare_exchange_cell(cell, expected, value, std::memory_order_relaxed);
    if (found == expected) {
      return;
    }
  }
}

template <cell_storage Storage>
void add_to_cell(Storage& storage, std::uint32_t cell, std::uint32_t amount) noexcept {
  std::uint32_t found = storage.load_cell(cell, std::memory_order_relaxed);
  while (amount > 0u && found < 0xffffffffu) {
    const std::uint32_t expected = found;
    found = storage.compare_exchange_cell(cell, expected, add_amounts(expected, amount), std::memory_order_relaxed);
    if (found == expected) {
      return;
    }
  }
}

}  // namespace pelage
