// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pelage::frame {
namespace {

/// Beyond the fibre's own radius, a disc reaches half a pixel; the rest is for rounding.
constexpr float margin = 0.75F;

int clamp_to_int(float x, int low, int high) {
  return static_cast<int>(std::clamp(x, static_cast<float>(low), static_cast<float>(high)));
}

}  // namespace

raster::raster(const strands& fibres, const view& from, bool antialias)
    : fibres_(fibres),
      view_(from),
      antialias_(antialias),
      position_(fibres.point.size()),
      pixel_(fibres.point.size()),
      joint_(fibres.point.size()) {
  const std::size_t count = position_.size();
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    position_[i] = view_.to_view(fibres_.point[i]);
    pixel_[i] = view_.to_pixel(position_[i]);
  });
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const bool has_before = (fibres_.end_of[i] & strands::first) == 0;
    const bool has_after = (fibres_.end_of[i] & strands::last) == 0;
    joint_[i] = (has_after ? pixel_[i + 1] : pixel_[i]) - (has_before ? pixel_[i - 1] : pixel_[i]);
  });
}

raster::outline raster::outline_of(std::uint32_t segment) const {
  const std::uint32_t i = fibres_.segment[segment];
  const float radius = std::max(fibres_.radius[i], fibres_.radius[i + 1]);
  const segment_quad<float> quad =
      expand_segment(position_[i], position_[i + 1], radius, view_.cone, view_.near_plane, margin);
  outline o{{}, quad.visible, true};
  for (std::size_t k = 0; k < 4; ++k) {
    o.bounded = o.bounded && (!view_.perspective || -quad.corner[k].z >= view_.near_plane);
    o.corner[k] = view_.to_pixel(quad.corner[k]);
  }
  return o;
}

pixel_rect raster::bounds(std::uint32_t segment) const {
  const outline quad = outline_of(segment);
  if (!quad.visible) return {0, 0, 0, 0};
  if (!quad.bounded) return {0, 0, view_.width, view_.height};
  glm::vec2 lower = quad.corner[0];
  glm::vec2 upper = quad.corner[0];
  for (const glm::vec2& c : quad.corner) {
    lower = glm::min(lower, c);
    upper = glm::max(upper, c);
  }
  return {clamp_to_int(std::floor(lower.x), 0, view_.width), clamp_to_int(std::floor(lower.y), 0, view_.height),
          clamp_to_int(std::ceil(upper.x), 0, view_.width), clamp_to_int(std::ceil(upper.y), 0, view_.height)};
}

}  // namespace pelage::frame
