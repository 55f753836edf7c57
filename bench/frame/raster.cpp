// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster.hpp"

#include <pelage/coverage/segment_quad.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::frame {
namespace {

/// Pixel coordinates up to which rounding stays below `rounding` pixels; a view's sides are half of it.
constexpr float farthest = 32768.0F;
constexpr float rounding = 0.1F;

/// What `half` is where a row's pixels are limited by the box alone.
constexpr float anywhere = 4.0F * farthest;

/// The greatest factor from the gap between a ray and a point of a fibre, in pixels at the point's depth, to their
/// distance on the screen. The gap stands at right angles to the ray, not to the view; and a pixel's disc is measured
/// at the ray's depth, which is greater than the point's by the gap at most.
float screen_stretch(const view& from) {
  if (!from.perspective) return 1.0F;
  const float steepest = glm::length(glm::vec3(from.ray({0.0F, 0.0F}).direction));
  return from.cone.slope < 1.0F ? steepest / (1.0F - from.cone.slope) : std::numeric_limits<float>::infinity();
}

}  // namespace

raster::raster(const strands& fibres, const view& from, bool antialias)
    : fibres_(fibres), view_(from), antialias_(antialias), stretch_(screen_stretch(from)), point_(fibres.point.size()) {
  const std::size_t count = point_.size();
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const glm::vec3 position = view_.to_view(fibres_.point[i]);
    point_[i] = {position, fibres_.radius[i], view_.to_pixel(position), glm::vec2(0.0F)};
  });
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const bool has_before = (fibres_.end_of[i] & strands::first) == 0;
    const bool has_after = (fibres_.end_of[i] & strands::last) == 0;
    point_[i].joint = point_[has_after ? i + 1 : i].pixel - point_[has_before ? i - 1 : i].pixel;
  });
}

raster::outline raster::outline_of(std::uint32_t segment) const {
  const std::uint32_t i = fibres_.segment[segment];
  const glm::vec2& a = point_[i].pixel;
  const glm::vec2& b = point_[i + 1].pixel;
  const float nearest = -std::max(point_[i].position.z, point_[i + 1].position.z);
  const float radius = std::max(point_[i].radius, point_[i + 1].radius);
  const float pixels = radius * view_.scale / (view_.perspective ? nearest : 1.0F);
  const float reach = stretch_ * (pixels + 0.5F) + rounding;
  const bool on_screen =
      std::abs(a.x) < farthest && std::abs(a.y) < farthest && std::abs(b.x) < farthest && std::abs(b.y) < farthest;
  if (!(nearest >= view_.near_plane && reach < farthest && on_screen)) return wide_outline_of(segment);
  const pixel_rect box = centres_in(glm::min(a, b) - reach, glm::max(a, b) + reach);
  const glm::vec2 span = b - a;
  if (std::abs(span.x) >= 64.0F * std::abs(span.y)) return {box, a.x, a.y, 0.0F, anywhere};
  const float slope = span.x / span.y;
  return {box, a.x, a.y, slope, reach * std::sqrt(1.0F + slope * slope)};
}

raster::outline raster::wide_outline_of(std::uint32_t segment) const {
  constexpr float margin = 0.75F;  // a disc reaches half a pixel beyond the fibre; the rest is for rounding
  const std::uint32_t i = fibres_.segment[segment];
  const float radius = std::max(point_[i].radius, point_[i + 1].radius);
  const segment_quad<float> quad =
      expand_segment(point_[i].position, point_[i + 1].position, radius, view_.cone, view_.near_plane, margin);
  if (!quad.visible) return {{0, 0, 0, 0}, 0.0F, 0.0F, 0.0F, anywhere};
  glm::vec2 lower(std::numeric_limits<float>::infinity());
  glm::vec2 upper = -lower;
  for (const glm::vec3& corner : quad.corner) {
    if (view_.perspective && !(-corner.z >= view_.near_plane)) {
      return {{0, 0, view_.width, view_.height}, 0.0F, 0.0F, 0.0F, anywhere};
    }
    lower = glm::min(lower, view_.to_pixel(corner));
    upper = glm::max(upper, view_.to_pixel(corner));
  }
  return {centres_in(lower, upper), 0.0F, 0.0F, 0.0F, anywhere};
}

pixel_rect raster::centres_in(const glm::vec2& lower, const glm::vec2& upper) const {
  return {first_centre_from(lower.x, 0, view_.width), first_centre_from(lower.y, 0, view_.height),
          first_centre_from(upper.x, 0, view_.width), first_centre_from(upper.y, 0, view_.height)};
}

}  // namespace pelage::frame
