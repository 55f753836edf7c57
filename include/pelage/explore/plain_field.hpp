// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <thread>

namespace pelage::explore {

/// What a structure that can be explored has in place of a field of type T: the field, and nothing else. Under test
/// watched_field takes its place.
template <class T>
class plain_field {
 public:
  plain_field(T value = T{}) : value_(value) {}

  [[nodiscard]] T read() const { return value_; }
  void write(T value) { value_ = value; }

 private:
  T value_;
};

/// Waits until `cell`, a std::atomic or a watched_atomic, is read as `value`. A std::atomic is polled.
template <class Atomic, class T>
void await(Atomic& cell, T value, std::memory_order order = std::memory_order_seq_cst) {
  if constexpr (requires { cell.await(value, order); }) {
    cell.await(value, order);
  } else {
    while (cell.load(order) != value) {
      std::this_thread::yield();
    }
  }
}

/// A fence for atomics of type Atomic: fence<Atomic<int>>(order).
template <class Atomic>
void fence(std::memory_order order) {
  if constexpr (requires { Atomic::fence(order); }) {
    Atomic::fence(order);
  } else {
    std::atomic_thread_fence(order);
  }
}

}  // namespace pelage::explore
