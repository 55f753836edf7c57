// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/backdrop.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace pelage::frame {

backdrop::backdrop(const view& eye, const scene& world, bool antialias)
    : side_(antialias ? 3 : 1), picture_(eye.width, eye.height) {
  nearest_.resize(picture_.pixels.size());
  limit_.resize(picture_.pixels.size());
  sample_depth_.resize(static_cast<std::size_t>(side_ * side_) * limit_.size());
  tbb::parallel_for(0, picture_.height, [&](int y) {
    for (int x = 0; x < picture_.width; ++x)
      see(eye, world, x, y);
  });
}

void backdrop::see(const view& eye, const scene& world, int x, int y) {
  const int samples = side_ * side_;
  const std::size_t pixel = static_cast<std::size_t>(y * picture_.width + x);
  float* depth = sample_depth_.data() + static_cast<std::size_t>(samples) * pixel;
  glm::vec3 sum(0.0F);
  for (int s = 0; s < samples; ++s) {
    const view_ray ray = eye.ray(sample_position(x, y, s));
    const glm::vec3 origin = eye.eye + eye.direction_to_world(ray.origin);
    const glm::vec3 direction = eye.direction_to_world(ray.direction);
    const auto hit = world.opaque.hit(origin, direction);
    depth[s] = hit ? hit->distance : std::numeric_limits<float>::infinity();
    const glm::vec3 far = world.background(direction);
    sum += hit ? glm::mix(world.solid_radiance(origin + hit->distance * direction, *hit), far, hit->haze) : far;
  }
  const auto [nearest, farthest] = std::minmax_element(depth, depth + samples);
  nearest_[pixel] = *nearest;
  limit_[pixel] = *farthest;
  picture_.at(x, y) = sum / static_cast<float>(samples);
}

glm::vec2 backdrop::sample_position(int x, int y, int sample) const {
  const glm::vec2 corner(static_cast<float>(x), static_cast<float>(y));
  const glm::vec2 inside(static_cast<float>(sample % side_) + 0.5F, static_cast<float>(sample / side_) + 0.5F);
  return corner + inside / static_cast<float>(side_);
}

float backdrop::share_behind(std::size_t pixel, float depth) const {
  if (depth < nearest_[pixel]) return 1.0F;
  const int samples = side_ * side_;
  const float* sample = sample_depth_.data() + static_cast<std::size_t>(samples) * pixel;
  const auto behind = std::count_if(sample, sample + samples, [&](float d) { return depth < d; });
  return static_cast<float>(behind) / static_cast<float>(samples);
}

}  // namespace pelage::frame
