// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/opaque_depth.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace pelage::frame {

std::vector<float> opaque_depths(const view& from, const solids& opaque) {
  const auto width = static_cast<std::size_t>(from.width);
  std::vector<float> depth(width * static_cast<std::size_t>(from.height));
  tbb::parallel_for(0, from.height, [&](int y) {
    float* const row = &depth[static_cast<std::size_t>(y) * width];
    for (int x = 0; x < from.width; x += wide_width) {
      const wide_rays rays =
          from.world_ray(counted_from(static_cast<float>(x) + 0.5F), wide(static_cast<float>(y) + 0.5F));
      const wide found = opaque.hit(rays.origin, rays.direction).distance;
      for (int k = 0; k < std::min(wide_width, from.width - x); ++k)
        row[x + k] = found.lane[k];
    }
  });
  return depth;
}

}  // namespace pelage::frame
