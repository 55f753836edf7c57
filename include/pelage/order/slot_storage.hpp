// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <span>

namespace pelage {

/// Where the slots of atomic_k_buffer live: 64-bit cells, each reached by a call that names its memory order, so that
/// the same algorithm runs on std::atomic_ref, on a shader's buffer and on cells that a concurrency test watches.
/// min_slot() leaves the smaller of a cell and a value in the cell, and returns what the cell held before.
template <class Storage>
concept slot_storage = requires(Storage& s, const Storage& c, std::uint32_t n, std::uint64_t value,
                                std::memory_order order) {
  { c.slot_count() } -> std::same_as<std::uint32_t>;
  { c.load_slot(n, order) } -> std::same_as<std::uint64_t>;
  { s.min_slot(n, value, order) } -> std::same_as<std::uint64_t>;
};

/// Where the slots of two_pass_k_buffer live: a 32-bit depth and a 32-bit id each, otherwise as slot_storage.
template <class Storage>
concept split_slot_storage = requires(Storage& s, const Storage& c, std::uint32_t n, std::uint32_t value,
                                      std::memory_order order) {
  { c.slot_count() } -> std::same_as<std::uint32_t>;
  { c.load_depth(n, order) } -> std::same_as<std::uint32_t>;
  { s.min_depth(n, value, order) } -> std::same_as<std::uint32_t>;
  { c.load_id(n, order) } -> std::same_as<std::uint32_t>;
  { s.min_id(n, value, order) } -> std::same_as<std::uint32_t>;
};

/// A fragment as a number that orders as the fragment does: depth_key in the high word, id in the low one. What
/// no_fragment() gives is above that of every fragment. For fragments that is_fragment() accepts, or no_fragment().
[[nodiscard]] constexpr std::uint64_t pack(fragment f) noexcept {
  return (static_cast<std::uint64_t>(depth_key(f.depth)) << 32u) | static_cast<std::uint64_t>(f.id);
}

/// The fragment that was packed, but for the sign of a zero depth.
[[nodiscard]] constexpr fragment unpack(std::uint64_t packed) noexcept {
  return fragment{depth_from_key(static_cast<std::uint32_t>(packed >> 32u)), static_cast<std::uint32_t>(packed)};
}

/// Atomic minimum by compare-exchange, for cells that have none of their own (C++ brings one only in 2026). Returns
/// what the cell held before. Lock-free: an exchange fails only because another thread made the cell smaller. Where
/// the value is not smaller, it is a relaxed load and no more.
template <class Cell, class Value>
Value fetch_minimum(Cell&& cell, Value value, std::memory_order order) noexcept {
  Value held = cell.load(std::memory_order_relaxed);
  while (value < held && !cell.compare_exchange_strong(held, value, order, std::memory_order_relaxed)) {
  }
  return held;
}

/// slot_storage over the caller's memory, atomic through std::atomic_ref. 8 bytes a slot.
struct atomic_slot_storage {
  std::span<std::uint64_t> slots;  ///< pixel after pixel; clear() before use

  /// Empties every slot. Not concurrent.
  void clear() noexcept { std::fill(slots.begin(), slots.end(), pack(no_fragment())); }

  [[nodiscard]] std::uint32_t slot_count() const noexcept { return static_cast<std::uint32_t>(slots.size()); }
  [[nodiscard]] std::uint64_t load_slot(std::uint32_t slot, std::memory_order order) const noexcept {
    return std::atomic_ref(slots[slot]).load(order);
  }
  std::uint64_t min_slot(std::uint32_t slot, std::uint64_t value, std::memory_order order) noexcept {
    return fetch_minimum(std::atomic_ref(slots[slot]), value, order);
  }
};

static_assert(slot_storage<atomic_slot_storage>);

/// split_slot_storage over the caller's memory, likewise. 8 bytes a slot.
struct atomic_split_slot_storage {
  std::span<std::uint32_t> depths;  ///< depth keys, pixel after pixel; clear() before use
  std::span<std::uint32_t> ids;     ///< as many

  /// Empties every slot. Not concurrent.
  void clear() noexcept {
    std::fill(depths.begin(), depths.end(), 0xffffffffu);
    std::fill(ids.begin(), ids.end(), no_fragment().id);
  }

  [[nodiscard]] std::uint32_t slot_count() const noexcept { return static_cast<std::uint32_t>(depths.size()); }
  [[nodiscard]] std::uint32_t load_depth(std::uint32_t slot, std::memory_order order) const noexcept {
    return std::atomic_ref(depths[slot]).load(order);
  }
  std::uint32_t min_depth(std::uint32_t slot, std::uint32_t key, std::memory_order order) noexcept {
    return fetch_minimum(std::atomic_ref(depths[slot]), key, order);
  }
  [[nodiscard]] std::uint32_t load_id(std::uint32_t slot, std::memory_order order) const noexcept {
    return std::atomic_ref(ids[slot]).load(order);
  }
  std::uint32_t min_id(std::uint32_t slot, std::uint32_t id, std::memory_order order) noexcept {
    return fetch_minimum(std::atomic_ref(ids[slot]), id, order);
  }
};

static_assert(split_slot_storage<atomic_split_slot_storage>);

}  // namespace pelage
