// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>

namespace pelage {

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

}  // namespace pelage
