// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster/raster.hpp"

#include <pelage/coverage/segment_quad.hpp>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::frame {
float screen_stretch(const view& from) {
  if (!from.perspective) return 1.0F;
  const float steepest = glm::length(glm::vec3(from.ray(0.0F, 0.0F).direction));
  return from.cone.slope < 1.0F ? steepest / (1.0F - from.cone.slope) : std::numeric_limits<float>::infinity();
}

raster::raster(const strands& fibres, const view& from, bool antialias, std::optional<float> eta)
    : fibres_(fibres),
      view_(from),
      antialias_(antialias),
      stretch_(screen_stretch(from)),
      opacity_(eta ? view_opacity(fibres, from, *eta) : view_opacity(fibres)),
      point_(fibres.point.size()) {
  const std::size_t count = point_.size();
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const glm::vec3 position = view_.to_view(fibres_.point[i]);
    const glm::vec2 pixel = view_.to_pixel(position);
    point_[i] = {position.x, position.y, position.z, fibres_.radius[i], pixel.x, pixel.y, 0.0F, 0.0F};
  });
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const bool has_before = (fibres_.end_of[i] & strands::first) == 0;
    const bool has_after = (fibres_.end_of[i] & strands::last) == 0;
    const glm::vec2 joint = pixel_of(point_[has_after ? i + 1 : i]) - pixel_of(point_[has_before ? i - 1 : i]);
    point_[i].joint_x = joint.x;
    point_[i].joint_y = joint.y;
  });
}

raster::raster(const strands& fibres, const view& from, bool antialias, const line_depths& lines,
               std::optional<float> eta)
    : raster(fibres, from, antialias, eta) {
  drawn_ = primitive::line;
  line_depths_ = lines;
  stretch_ *= lines.widening;
}

line_depths line_depths_of(const strands& fibres, const view& from, std::uint32_t bins, float at) {
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = from.near_plane;
  for (const glm::vec3& point : fibres.point) {
    const float depth = std::max(-from.to_view(point).z, from.near_plane);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  line_depths found{at};
  if (bins > 0) found.nearest = farthest;
  if (bins > 0 && farthest > nearest) {
    const auto count = static_cast<float>(bins);
    found = {nearest, (farthest - nearest) / count, count - 1.0F};
  }
  if (from.perspective) {
    const float ratio = found.bin > 0.0F ? 1.0F + found.bin / nearest : farthest / found.nearest;
    found.widening = std::max(1.0F, 1.01F * ratio);
  }
  return found;
}

pixel_rect raster::bounds(std::uint32_t segment) const {
  const std::uint32_t i = fibres_.segment[segment];
  const outline<float> near = outline_of(point_[i], point_[i + 1], view_, stretch_);
  const outline<float> found = near.fails > 0.0F ? wide_outline_of(segment) : near;
  return {static_cast<int>(found.x0), static_cast<int>(found.y0), static_cast<int>(found.x1),
          static_cast<int>(found.y1)};
}

depth_range raster::seen_depths(std::span<const float> limit) const {
  const auto width = static_cast<float>(view_.width);
  const auto height = static_cast<float>(view_.height);
  struct part {
    depth_range range = depth_range::empty();
  };
  tbb::enumerable_thread_specific<part> parts;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, point_.size(), 4096), [&](const tbb::blocked_range<std::size_t>& some) {
        depth_range& range = parts.local().range;
        for (std::size_t i = some.begin(); i < some.end(); ++i) {
          const glm::vec2 at = pixel_of(point_[i]);
          const float depth = -point_[i].z;
          if (!(at.x >= 0.0F && at.x < width && at.y >= 0.0F && at.y < height)) continue;
          const auto pixel =
              static_cast<std::size_t>(at.y) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(at.x);
          const bool hidden = !limit.empty() && depth >= limit[pixel];
          if (depth >= view_.near_plane && !hidden) range.extend(depth);
        }
      });
  depth_range all = depth_range::empty();
  for (const part& one : parts)
    all.merge(one.range);
  return all;
}

outline<float> raster::wide_outline_of(std::uint32_t segment) const {
  constexpr float margin = 0.75F;  // half a disc reaches beyond the fibre; the rest is for rounding
  const std::uint32_t i = fibres_.segment[segment];
  if (drawn_ == primitive::line) {
    return {0.0F,         0.0F, static_cast<float>(view_.width), static_cast<float>(view_.height), 0.0F, 0.0F, 0.0F,
            any_distance, 0.0F};
  }
  const float radius = std::max(point_[i].radius, point_[i + 1].radius);
  const segment_quad<float> quad =
      expand_segment(position_of(point_[i]), position_of(point_[i + 1]), radius, view_.cone, view_.near_plane, margin);
  if (!quad.visible) return {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, any_distance, 0.0F};
  const glm::vec2 size(static_cast<float>(view_.width), static_cast<float>(view_.height));
  glm::vec2 lower(std::numeric_limits<float>::infinity());
  glm::vec2 upper = -lower;
  for (const glm::vec3& corner : quad.corner) {
    if (view_.perspective && !(-corner.z >= view_.near_plane)) {
      return {0.0F, 0.0F, size.x, size.y, 0.0F, 0.0F, 0.0F, any_distance, 0.0F};
    }
    lower = glm::min(lower, view_.to_pixel(corner));
    upper = glm::max(upper, view_.to_pixel(corner));
  }
  return {first_centre_from(lower.x, 0.0F, size.x),
          first_centre_from(lower.y, 0.0F, size.y),
          first_centre_from(upper.x, 0.0F, size.x),
          first_centre_from(upper.y, 0.0F, size.y),
          0.0F,
          0.0F,
          0.0F,
          any_distance,
          0.0F};
}

}  // namespace pelage::frame
