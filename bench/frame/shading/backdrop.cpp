// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/backdrop.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>

namespace pelage::frame {
namespace {

constexpr std::size_t most_samples = 9;  ///< a pixel

}  // namespace

backdrop::backdrop(const view& eye, const scene& world, bool antialias)
    : side_(antialias ? 3 : 1), picture_(eye.width, eye.height) {
  const std::size_t pixels = picture_.pixels.size();
  limit_.resize(pixels);
  edge_.resize(pixels);
  far_share_.resize(pixels);
  far_light_.resize(pixels);
  tbb::parallel_for(0, picture_.height, [&](int y) {
    for (int x = 0; x < picture_.width; x += wide_width)
      see(eye, world, x, y);
  });
}

void backdrop::see(const view& eye, const scene& world, int x, int y) {
  const auto offset = [this](int sample) { return (static_cast<float>(sample) + 0.5F) / static_cast<float>(side_); };
  const wide infinite(std::numeric_limits<float>::infinity());
  const wide samples(static_cast<float>(side_ * side_));
  std::array<scene::backdrop_rays, most_samples> seen;
  const std::span<scene::backdrop_rays> all = std::span(seen).first(static_cast<std::size_t>(side_ * side_));
  wide nearest = infinite;
  wide farthest(0.0F);
  wide3 sum(wide(0.0F));
  int s = 0;
  for (scene::backdrop_rays& one : all) {
    const wide across = counted_from(static_cast<float>(x)) + wide(offset(s % side_));
    one = world.seen_behind(eye.world_ray(across, wide(static_cast<float>(y) + offset(s / side_))));
    nearest = least(one.depth, nearest);
    farthest = greatest(one.depth, farthest);
    sum = sum + one.radiance;
    ++s;
  }

  const wide parting = parting_depth(nearest, farthest);
  wide near_count(0.0F);
  wide near_depths(0.0F);
  wide3 far_sum(wide(0.0F));
  for (const scene::backdrop_rays& one : all) {
    const auto is_near = one.depth < parting;
    near_count = near_count + select(is_near, wide(1.0F), wide(0.0F));
    near_depths = near_depths + select(is_near, one.depth, wide(0.0F));
    far_sum = far_sum + select(is_near, wide3(wide(0.0F)), one.radiance);
  }
  const wide edge =
      select(near_count < samples, select(near_count > wide(0.0F), near_depths / near_count, infinite), infinite);
  const wide far_share = (samples - near_count) / samples;
  const wide3 far_light = far_sum / samples;
  const wide3 mean = sum / samples;
  const auto pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
  for (int k = 0; k < std::min(wide_width, picture_.width - x); ++k) {
    const std::size_t here = pixel + static_cast<std::size_t>(k);
    limit_[here] = farthest.lane[k];
    edge_[here] = edge.lane[k];
    far_share_[here] = far_share.lane[k];
    far_light_[here] = lane_of(far_light, k);
    picture_.pixels[here] = lane_of(mean, k);
  }
}

}  // namespace pelage::frame
