// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/fragment.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>

namespace pelage {

/// A fragment as a number that orders as the fragment does: depth_key in the high word, id in the low one. What
/// no_fragment() gives is above that of every fragment. For fragments that is_fragment() accepts, or no_fragment().
[[nodiscard]] constexpr std::uint64_t pack(fragment f) noexcept {
  return (static_cast<std::uint64_t>(depth_key(f.depth)) << 32u) | static_cast<std::uint64_t>(f.id);
}

/// The fragment that was packed, except for the sign of a zero depth.
[[nodiscard]] constexpr fragment unpack(std::uint64_t number) noexcept {
  return fragment{depth_from_key(static_cast<std::uint32_t>(number >> 32u)), static_cast<std::uint32_t>(number)};
}

/// The 64-bit cells of atomic_k_buffer over the caller's memory, atomic through std::atomic_ref. 8 bytes a slot.
struct atomic_slot_storage {
  std::span<std::uint64_t> slots;  ///< pixel after pixel; clear() before use

  /// Empties every slot. Not concurrent.
  void clear() noexcept { std::fill(slots.begin(), slots.end(), pack(no_fragment())); }

  [[nodiscard]] std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(slots.size()); }
  [[nodiscard]] std::uint64_t load(std::uint32_t slot, std::memory_order order) const noexcept {
    return std::atomic_ref(slots[slot]).load(order);
  }
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, std::memory_order order) noexcept {
    return fetch_minimum(std::atomic_ref(slots[slot]), value, order);
  }
};

static_assert(falling_cells<atomic_slot_storage, std::uint64_t>);

}  // namespace pelage
