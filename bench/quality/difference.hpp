// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pelage::frame {

/// The sum of squares and the largest of many differences.
struct difference {
  double squares = 0;
  double largest = 0;
  std::uint64_t count = 0;

  void see(double d) {
    squares += d * d;
    largest = std::max(largest, std::abs(d));
    ++count;
  }
  [[nodiscard]] double rms() const { return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0; }
};

}  // namespace pelage::frame
