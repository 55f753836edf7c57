// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/fragment.hpp>

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <span>

namespace pelage {

/// Where the slots of two_pass_k_buffer live: a 32-bit depth and a 32-bit id each, the verbs those of falling_cells.
template <class Storage>
concept split_slot_storage = requires(Storage& s, const Storage& c, std::uint32_t n, std::uint32_t value,
                                      std::memory_order order) {
  { c.slot_count() } -> std::same_as<std::uint32_t>;
  { c.load_depth(n, order) } -> std::same_as<std::uint32_t>;
  { s.min_depth(n, value, order) } -> std::same_as<std::uint32_t>;
  { c.load_id(n, order) } -> std::same_as<std::uint32_t>;
  { s.min_id(n, value, order) } -> std::same_as<std::uint32_t>;
};

/// split_slot_storage over the caller's memory, atomic through std::atomic_ref. 8 bytes a slot.
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
