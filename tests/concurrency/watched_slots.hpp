// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/packed_fragment.hpp>

#include "concurrency/watched_cells.hpp"

#include <cstdint>
#include <sstream>
#include <string>

namespace pelage::explore {

inline std::string show_packed(std::uint64_t packed) {
  const fragment f = unpack(packed);
  std::ostringstream text;
  text << '(' << f.depth << ", " << f.id << ')';
  return packed == pack(no_fragment()) ? "-" : text.str();
}

/// The cells of an atomic_k_buffer's pixel.
class watched_slots : public watched_cells<std::uint64_t> {
 public:
  explicit watched_slots(std::uint32_t count) { add_cells(count, "slot", pack(no_fragment()), &show_packed); }

  [[nodiscard]] std::string draw() const {
    std::string text;
    for (std::uint32_t i = 0; i < size(); ++i) {
      text += ' ' + show_packed(latest(i));
    }
    return text;
  }
};

/// The same with the library's minimum by compare-exchange.
struct watched_exchanged_slots : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, std::memory_order order) {
    return fetch_minimum(cell(slot), value, order);
  }
};

/// The cells of a split_k_buffer's pixel.
class watched_depths_and_ids : public watched_cells<std::uint32_t> {
 public:
  explicit watched_depths_and_ids(std::uint32_t count) {
    add_cells(count, "depth", 0xffffffffu);
    add_cells(count, "id", no_fragment().id);
  }

  [[nodiscard]] bool is_id(std::uint32_t n) const { return n >= size() / 2u; }

  [[nodiscard]] std::string draw() const {
    std::ostringstream text;
    for (std::uint32_t i = 0; i < size() / 2u; ++i) {
      const std::uint32_t key = latest(i);
      const std::uint32_t id = latest(size() / 2u + i);
      text << " (" << (key == 0xffffffffu ? "-" : std::to_string(depth_from_key(key))) << ", "
           << (id == no_fragment().id ? "-" : std::to_string(id)) << ')';
    }
    return text.str();
  }
};

}  // namespace pelage::explore
