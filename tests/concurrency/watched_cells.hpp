// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/atomic_cells.hpp>

#include <pelage/explore/watched.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pelage::explore {

/// cell_storage of watched cells, with the atomics of hardware.
template <class Word>
class watched_cells {
 public:
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  [[nodiscard]] Word load(std::uint32_t n, std::memory_order order) const { return cells_[n].load(order); }
  Word fetch_min(std::uint32_t n, Word value, std::memory_order order) { return cells_[n].fetch_min(value, order); }
  Word fetch_max(std::uint32_t n, Word value, std::memory_order order) { return cells_[n].fetch_max(value, order); }
  Word fetch_or(std::uint32_t n, Word bits, std::memory_order order) { return cells_[n].fetch_or(bits, order); }
  Word fetch_add(std::uint32_t n, Word amount, std::memory_order order) { return cells_[n].fetch_add(amount, order); }
  Word compare_exchange(std::uint32_t n, Word expected, Word desired, std::memory_order order) {
    cells_[n].compare_exchange_strong(expected, desired, order, std::memory_order_relaxed);
    return expected;
  }
  [[nodiscard]] watched_atomic<Word>& cell(std::uint32_t n) { return cells_[n]; }

 protected:
  /// Adds `count` cells of a value, numbered after a name.
  template <class... Show>
  void add_cells(std::uint32_t count, const std::string& name, Word value, Show... show) {
    for (std::uint32_t i = 0; i < count; ++i) {
      cells_.emplace_back(name + ' ' + std::to_string(i), value, show...);
    }
  }

  /// What a cell's latest store has.
  [[nodiscard]] Word latest(std::uint32_t n) const {
    return static_cast<Word>(world::current().memory().latest(cells_[n].location()));
  }

 private:
  std::vector<watched_atomic<Word>> cells_;
};

static_assert(cell_storage<watched_cells<std::uint32_t>> &&
              exchanged_cells<watched_cells<std::uint64_t>, std::uint64_t>);

}  // namespace pelage::explore
