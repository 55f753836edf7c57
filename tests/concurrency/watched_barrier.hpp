// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/watched.hpp>

#include <cstdint>

namespace pelage::explore {

/// What stands between two phases, as a counter of arrivals. The faults are its orders relaxed, and not to wait.
template <std::memory_order Arrive, std::memory_order Wait, bool Waits = true>
class watched_barrier {
 public:
  explicit watched_barrier(std::string_view name) : arrived_(name) {}

  void arrive() { arrived_.fetch_add(1u, Arrive); }
  void wait(int threads) {
    if (Waits) {
      arrived_.await(static_cast<std::uint32_t>(threads), Wait);
    }
  }

 private:
  watched_atomic<std::uint32_t> arrived_;
};

using sound_barrier = watched_barrier<std::memory_order_release, std::memory_order_acquire>;
using barrier_arriving_relaxed = watched_barrier<std::memory_order_relaxed, std::memory_order_acquire>;
using barrier_waiting_relaxed = watched_barrier<std::memory_order_release, std::memory_order_relaxed>;
using missing_barrier = watched_barrier<std::memory_order_release, std::memory_order_acquire, false>;

}  // namespace pelage::explore
