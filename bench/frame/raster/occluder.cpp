// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster/occluder.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace pelage::frame {

occluder::occluder(const raster& from, std::span<const float> limit)
    : from_(from), across_((from.from().width + side - 1) / side) {
  if (limit.empty()) return;
  const int width = from.from().width;
  const int height = from.from().height;
  const int down = (height + side - 1) / side;
  farthest_.assign(static_cast<std::size_t>(across_) * static_cast<std::size_t>(down), 0.0F);
  tbb::parallel_for(0, down, [&](int block) {
    for (int y = block * side; y < std::min((block + 1) * side, height); ++y) {
      const float* const row = &limit[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
      for (int x = 0; x < width; ++x) {
        float& farthest = farthest_[index(x / side, block)];
        farthest = std::max(farthest, row[x]);
      }
    }
  });
}

bool occluder::hides(std::uint32_t segment, const pixel_rect& bounds) const {
  if (farthest_.empty()) return false;
  constexpr float rounding = 1e-4F;
  const float depth = (1.0F - rounding) * from_.nearest_depth(segment);
  for (int y = bounds.y0 / side; y * side < bounds.y1; ++y) {
    for (int x = bounds.x0 / side; x * side < bounds.x1; ++x) {
      if (!(depth > farthest_[index(x, y)])) return false;
    }
  }
  return true;
}

}  // namespace pelage::frame
