// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "concurrency/watched_slots.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace pelage::explore {

// Faults that atomic_k_buffer and cascade_k_buffer share, planted in their cells.

/// A minimum in two steps, each atomic.
struct minimum_in_two_steps : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, std::memory_order o) {
    const std::uint64_t held = load(slot, o);
    cell(slot).store(std::min(held, value), o);
    return held;
  }
};

/// A minimum by compare-exchange that is tried once.
struct minimum_without_retry : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, std::memory_order o) {
    std::uint64_t held = load(slot, std::memory_order_relaxed);
    if (value < held) {
      (void)cell(slot).compare_exchange_strong(held, value, o, std::memory_order_relaxed);
    }
    return held;
  }
};

/// What falls out is what was put in, not what was found.
struct hands_back_the_smaller : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, std::memory_order o) {
    return std::min(watched_slots::fetch_min(slot, value, o), value);
  }
};

/// (1) looks at the first slot in place of the last.
struct refuses_too_early : watched_slots {
  using watched_slots::watched_slots;
  [[nodiscard]] std::uint64_t load(std::uint32_t slot, std::memory_order o) const {
    return watched_slots::load(world::current().thread() >= 0 && slot == size() - 1u ? 0u : slot, o);
  }
};

/// Everything seq_cst: a correct variant.
struct seq_cst_slots : watched_slots {
  using watched_slots::watched_slots;
  [[nodiscard]] std::uint64_t load(std::uint32_t slot, std::memory_order) const {
    return watched_slots::load(slot, std::memory_order_seq_cst);
  }
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, std::memory_order) {
    return watched_slots::fetch_min(slot, value, std::memory_order_seq_cst);
  }
  std::uint64_t compare_exchange(std::uint32_t slot, std::uint64_t expected, std::uint64_t desired, std::memory_order) {
    return watched_slots::compare_exchange(slot, expected, desired, std::memory_order_seq_cst);
  }
};

}  // namespace pelage::explore
