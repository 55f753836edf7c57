// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/opaque_depth.hpp"

#include <tbb/parallel_for.h>

#include <cstddef>
#include <limits>

namespace pelage::frame {

float opaque_depth(const view& from, const solids& opaque, const glm::vec2& pixel) {
  const view_ray ray = from.ray(pixel);
  const glm::vec3 origin = from.eye + from.direction_to_world(ray.origin);
  const auto hit = opaque.hit(origin, from.direction_to_world(ray.direction));
  return hit ? hit->distance : std::numeric_limits<float>::infinity();
}

std::vector<float> opaque_depths(const view& from, const solids& opaque) {
  const auto width = static_cast<std::size_t>(from.width);
  std::vector<float> depth(width * static_cast<std::size_t>(from.height));
  tbb::parallel_for(0, from.height, [&](int y) {
    for (int x = 0; x < from.width; ++x) {
      depth[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] =
          opaque_depth(from, opaque, {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
    }
  });
  return depth;
}

}  // namespace pelage::frame
