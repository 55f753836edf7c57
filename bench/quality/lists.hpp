// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "frame/order/order_pass.hpp"

namespace pelage::frame {

/// One fragment of a pixel's sorted list.
struct sample {
  float depth;
  float coverage;
  std::uint32_t id;
};

/// Every pixel's whole list, nearest first.
class lists final : public pixel_visitor {
 public:
  explicit lists(const raster& from) : from_(from) {}

  void expect(std::span<const std::uint32_t> fragments_per_pixel) override {
    first_.assign(1, 0);
    for (const std::uint32_t n : fragments_per_pixel)
      first_.push_back(first_.back() + n);
    all_.resize(first_.back());
  }
  void lose(int, int, std::span<const pixel_fragment>, std::span<tail>) override {}
  void finish(int x, int y, std::span<const pixel_fragment> nearest, std::span<const tail>) override {
    sample* out = all_.data() + first_[static_cast<std::size_t>(y * from_.from().width + x)];
    for (const pixel_fragment& f : nearest)
      *out++ = {f.depth, f.coverage, f.id};
  }

  [[nodiscard]] std::size_t pixels() const { return first_.size() - 1; }
  [[nodiscard]] std::size_t fragments() const { return all_.size(); }
  [[nodiscard]] std::span<const sample> of(std::size_t pixel) const {
    return std::span(all_).subspan(first_[pixel], first_[pixel + 1] - first_[pixel]);
  }

 private:
  const raster& from_;
  std::vector<std::size_t> first_;
  std::vector<sample> all_;
};

}  // namespace pelage::frame
