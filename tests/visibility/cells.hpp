// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/atomic_cells.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

/// What the tests of maps share: storages with their memory, and threads.
namespace pelage::test {

/// A storage together with its cells, all of one value at first.
template <class Storage>
class cells_of : public Storage {
 public:
  cells_of(std::uint32_t count, std::uint32_t value) : memory_(count, value) { this->words = memory_; }
  cells_of(const cells_of&) = delete;
  cells_of& operator=(const cells_of&) = delete;

  [[nodiscard]] const std::vector<std::uint32_t>& memory() const { return memory_; }

 private:
  std::vector<std::uint32_t> memory_;
};

/// Lets other threads run at times between the load of a cell and its change.
struct shaken_cells : atomic_cells<std::uint32_t> {
  std::uint32_t fetch_min(std::uint32_t cell, std::uint32_t value, std::memory_order order) {
    give_way();
    return fetch_minimum(shaken{std::atomic_ref(words[cell])}, value, order);
  }
  std::uint32_t fetch_max(std::uint32_t cell, std::uint32_t value, std::memory_order order) {
    give_way();
    return fetch_maximum(shaken{std::atomic_ref(words[cell])}, value, order);
  }
  std::uint32_t fetch_or(std::uint32_t cell, std::uint32_t bits, std::memory_order order) {
    give_way();
    return atomic_cells<std::uint32_t>::fetch_or(cell, bits, order);
  }
  std::uint32_t fetch_add(std::uint32_t cell, std::uint32_t amount, std::memory_order order) {
    give_way();
    return atomic_cells<std::uint32_t>::fetch_add(cell, amount, order);
  }
  std::uint32_t compare_exchange(std::uint32_t cell, std::uint32_t expected, std::uint32_t desired,
                                 std::memory_order order) {
    give_way();
    return atomic_cells<std::uint32_t>::compare_exchange(cell, expected, desired, order);
  }

 private:
  static void give_way() {
    thread_local std::uint32_t calls = 0u;
    calls = calls * 1664525u + 1013904223u;
    if (calls >> 30u == 0u) std::this_thread::yield();
  }

  /// What fetch_minimum() and fetch_maximum() see of a cell.
  struct shaken {
    std::atomic_ref<std::uint32_t> cell;
    [[nodiscard]] std::uint32_t load(std::memory_order order) const { return cell.load(order); }
    bool compare_exchange_strong(std::uint32_t& expected, std::uint32_t desired, std::memory_order success,
                                 std::memory_order failure) const {
      give_way();
      return cell.compare_exchange_strong(expected, desired, success, failure);
    }
  };
};

/// A fault: two steps where the concept asks for one.
struct torn_cells : atomic_cells<std::uint32_t> {
  std::uint32_t fetch_min(std::uint32_t cell, std::uint32_t value, std::memory_order order) {
    const std::uint32_t found = load(cell, order);
    return put(cell, std::min(found, value), found, order);
  }
  std::uint32_t fetch_max(std::uint32_t cell, std::uint32_t value, std::memory_order order) {
    const std::uint32_t found = load(cell, order);
    return put(cell, std::max(found, value), found, order);
  }
  std::uint32_t fetch_or(std::uint32_t cell, std::uint32_t bits, std::memory_order order) {
    const std::uint32_t found = load(cell, order);
    return put(cell, found | bits, found, order);
  }
  std::uint32_t fetch_add(std::uint32_t cell, std::uint32_t amount, std::memory_order order) {
    const std::uint32_t found = load(cell, order);
    return put(cell, found + amount, found, order);
  }
  std::uint32_t compare_exchange(std::uint32_t cell, std::uint32_t expected, std::uint32_t desired,
                                 std::memory_order order) {
    return put(cell, desired, expected, order);
  }

 private:
  std::uint32_t put(std::uint32_t cell, std::uint32_t value, std::uint32_t found, std::memory_order order) {
    std::this_thread::yield();
    std::atomic_ref(words[cell]).store(value, order);
    return found;
  }
};

/// Calls change(i) for each i of [0, count), the numbers dealt out to threads in turn.
template <class Change>
void deal_to_threads(std::uint32_t threads, std::size_t count, Change&& change) {
  std::atomic<std::uint32_t> ready = 0u;
  std::vector<std::jthread> running;
  for (std::uint32_t thread = 0u; thread < threads; ++thread) {
    running.emplace_back([&, thread] {
      ++ready;
      while (ready < threads) {
        std::this_thread::yield();
      }
      for (std::size_t i = thread; i < count; i += threads) {
        change(i);
      }
    });
  }
}

}  // namespace pelage::test
