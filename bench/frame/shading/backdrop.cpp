// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/backdrop.hpp"

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
    for (int x = 0; x < picture_.width; x += wide_width)
      see(eye, world, x, y);
  });
}

void backdrop::see(const view& eye, const scene& world, int x, int y) {
  const int samples = side_ * side_;
  const auto offset = [this](int sample) { return (static_cast<float>(sample) + 0.5F) / static_cast<float>(side_); };
  const int count = std::min(wide_width, picture_.width - x);
  const auto pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
  float* const depth = sample_depth_.data() + static_cast<std::size_t>(samples) * pixel;
  wide nearest(std::numeric_limits<float>::infinity());
  wide farthest(0.0F);
  wide3 sum(wide(0.0F));
  for (int s = 0; s < samples; ++s) {
    const wide across = counted_from(static_cast<float>(x)) + wide(offset(s % side_));
    const scene::backdrop_rays seen =
        world.seen_behind(eye.world_ray(across, wide(static_cast<float>(y) + offset(s / side_))));
    for (int k = 0; k < count; ++k)
      depth[k * samples + s] = seen.depth.lane[k];
    nearest = least(seen.depth, nearest);
    farthest = greatest(seen.depth, farthest);
    sum = sum + seen.radiance;
  }
  const wide3 mean = sum / wide(static_cast<float>(samples));
  for (int k = 0; k < count; ++k) {
    const std::size_t here = pixel + static_cast<std::size_t>(k);
    nearest_[here] = nearest.lane[k];
    limit_[here] = farthest.lane[k];
    picture_.pixels[here] = lane_of(mean, k);
  }
}

float backdrop::share_behind(std::size_t pixel, float depth) const {
  if (depth < nearest_[pixel]) return 1.0F;
  const int samples = side_ * side_;
  const float* sample = sample_depth_.data() + static_cast<std::size_t>(samples) * pixel;
  const auto behind = std::count_if(sample, sample + samples, [&](float d) { return depth < d; });
  return static_cast<float>(behind) / static_cast<float>(samples);
}

}  // namespace pelage::frame
