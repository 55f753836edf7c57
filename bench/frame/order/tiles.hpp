// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "frame/base/big_array.hpp"
#include "frame/raster/raster.hpp"

namespace pelage::frame {

/// The view cut into square tiles, and for each the segments that may touch it, in the order of drawing.
class tiles {
 public:
  static constexpr int side = 32;  ///< pixels

  /// `limit`: view depth per pixel, at and behind which nothing is seen, or empty; segments that it hides whole are in
  /// no list. `drawing_order`: the segments' numbers in any order, or empty for 0, 1, 2…  The lists' order follows it,
  /// on any number of threads. O(segments + entries), parallel; 4 bytes an entry.
  tiles(const raster& from, std::span<const float> limit, std::span<const std::uint32_t> drawing_order);

  [[nodiscard]] int count() const { return across_ * down_; }
  [[nodiscard]] pixel_rect rect(int tile) const;
  [[nodiscard]] std::span<const std::uint32_t> segments(int tile) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  int width_, height_, across_, down_;
  std::vector<std::size_t> first_;  ///< count() + 1 positions in entry_
  big_array<std::uint32_t> entry_;
};

}  // namespace pelage::frame
