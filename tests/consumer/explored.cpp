// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/explore/explore.hpp>

#include <cstdlib>

struct lost_update : pelage::explore::program {
  [[nodiscard]] int threads() const override { return 2; }
  void thread(int) override { sum.store(sum.load() + 1); }
  void finish() override { pelage::explore::expect(sum.load() == 2, "lost"); }
  pelage::explore::watched_atomic<int> sum;
};

[[maybe_unused]] const bool found = [] {
  if (pelage::explore::explore_all([] { return std::make_unique<lost_update>(); }).fault != "lost") {
    std::abort();
  }
  return true;
}();
