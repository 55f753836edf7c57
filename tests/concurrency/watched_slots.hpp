// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/slot_storage.hpp>
#include <pelage/order/split_slot_storage.hpp>

#include "concurrency/watched.hpp"

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace pelage::explore {

inline std::string show_packed(std::uint64_t packed) {
  const fragment f = unpack(packed);
  std::ostringstream text;
  text << '(' << f.depth << ", " << f.id << ')';
  return packed == pack(no_fragment()) ? "-" : text.str();
}

/// falling_cells of watched cells, with an atomic minimum as hardware has it.
class watched_slots {
 public:
  explicit watched_slots(std::uint32_t count) {
    slots_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      slots_.emplace_back("slot " + std::to_string(i), pack(no_fragment()), &show_packed);
    }
  }

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(slots_.size()); }
  [[nodiscard]] std::uint64_t load(std::uint32_t slot, std::memory_order order) const {
    return slots_[slot].load(order);
  }
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, std::memory_order order) {
    return slots_[slot].fetch_min(value, order);
  }
  [[nodiscard]] watched_atomic<std::uint64_t>& cell(std::uint32_t slot) { return slots_[slot]; }

  [[nodiscard]] std::string draw() const {
    std::string text;
    for (const auto& slot : slots_) {
      text += ' ' + show_packed(world::current().memory().latest(slot.location()));
    }
    return text;
  }

 private:
  std::vector<watched_atomic<std::uint64_t>> slots_;
};

static_assert(falling_cells<watched_slots, std::uint64_t>);

/// The same with the library's minimum by compare-exchange.
struct watched_exchanged_slots : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, std::memory_order order) {
    return fetch_minimum(cell(slot), value, order);
  }
};

/// split_slot_storage of watched cells.
class watched_split_slots {
 public:
  explicit watched_split_slots(std::uint32_t count) {
    depths_.reserve(count);
    ids_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      depths_.emplace_back("depth " + std::to_string(i), 0xffffffffu);
      ids_.emplace_back("id " + std::to_string(i), no_fragment().id);
    }
  }

  [[nodiscard]] std::uint32_t slot_count() const { return static_cast<std::uint32_t>(depths_.size()); }
  [[nodiscard]] std::uint32_t load_depth(std::uint32_t slot, std::memory_order order) const {
    return depths_[slot].load(order);
  }
  std::uint32_t min_depth(std::uint32_t slot, std::uint32_t key, std::memory_order order) {
    return depths_[slot].fetch_min(key, order);
  }
  [[nodiscard]] std::uint32_t load_id(std::uint32_t slot, std::memory_order order) const {
    return ids_[slot].load(order);
  }
  std::uint32_t min_id(std::uint32_t slot, std::uint32_t id, std::memory_order order) {
    return ids_[slot].fetch_min(id, order);
  }
  [[nodiscard]] watched_atomic<std::uint32_t>& depth_cell(std::uint32_t slot) { return depths_[slot]; }
  [[nodiscard]] watched_atomic<std::uint32_t>& id_cell(std::uint32_t slot) { return ids_[slot]; }

  [[nodiscard]] std::string draw() const {
    const memory& cells = world::current().memory();
    std::ostringstream text;
    for (std::size_t i = 0; i < depths_.size(); ++i) {
      const auto key = static_cast<std::uint32_t>(cells.latest(depths_[i].location()));
      const auto id = static_cast<std::uint32_t>(cells.latest(ids_[i].location()));
      text << " (" << (key == 0xffffffffu ? "-" : std::to_string(depth_from_key(key))) << ", "
           << (id == no_fragment().id ? "-" : std::to_string(id)) << ')';
    }
    return text.str();
  }

 private:
  std::vector<watched_atomic<std::uint32_t>> depths_;
  std::vector<watched_atomic<std::uint32_t>> ids_;
};

static_assert(split_slot_storage<watched_split_slots>);

}  // namespace pelage::explore
