// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lanes.hpp>
#include <pelage/visibility/depth_range.hpp>

#include <glm/glm.hpp>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "frame/model/strands.hpp"
#include "frame/raster/fragment_lanes.hpp"
#include "frame/raster/line_in_pixel.hpp"
#include "frame/raster/outline.hpp"
#include "frame/raster/segment_in_pixel.hpp"
#include "frame/raster/view_opacity.hpp"
#include "frame/scene/view.hpp"

namespace pelage::frame {

/// All strands as one view sees them, and the fragments that they leave in its pixels. The same question asked
/// twice gives the same bits, so that a fragment's depth and coverage need not be kept: its id finds them again.
///
/// Where two segments of a strand meet, the line through the joint at right angles to the strand divides the pixels
/// between them, so that none is counted twice. Beside segments that cross the near plane the line is an estimate.
class raster {
 public:
  static constexpr int width = lane_width();
  /// `antialias` off: a pixel is covered whole if the axis crosses its disc or the fibre its centre, else not at all.
  /// `eta`: fibres stop what clear ones of this index do, by their inclination to the view's rays; none: what the model
  /// says. Both references must outlive the raster. O(points), parallel.
  raster(const strands& fibres, const view& from, bool antialias, std::optional<float> eta = {});

  /// The same of lines.
  raster(const strands& fibres, const view& from, bool antialias, const line_depths& lines,
         std::optional<float> eta = {});

  /// The fragment of a segment in a pixel of the view.
  [[nodiscard]] pixel_fragment at(std::uint32_t segment, int x, int y) const;

  // The bodies of what visits many pixels stand in sweep.hpp.

  /// Calls `visit(drawn_fragments)` until every pixel of `clip` is told that a segment covers in part: segment by
  /// segment, each row by row. The fastest way: pixels of many segments go through the kernels together.
  template <class Visit>
  void for_each_lanes(std::span<const std::uint32_t> segments, const pixel_rect& clip, Visit&& visit) const;

  /// Calls `visit(x, y, pixel_fragment)` for each of the same.
  template <class Visit>
  void for_each(std::span<const std::uint32_t> segments, const pixel_rect& clip, Visit&& visit) const;

  /// The same for one segment.
  template <class Visit>
  void for_each(std::uint32_t segment, const pixel_rect& clip, Visit&& visit) const {
    for_each(std::span(&segment, 1), clip, visit);
  }

  /// The pixels of the view that the segment may touch; empty (x0 >= x1 or y0 >= y1) when there are none.
  [[nodiscard]] pixel_rect bounds(std::uint32_t segment) const;

  /// Calls `visit(segment, bounds)` for segments [begin, end).
  template <class Visit>
  void for_each_bounds(std::uint32_t begin, std::uint32_t end, Visit&& visit) const;

  /// A view depth that none of the segment's fragments lies before, rounding apart.
  [[nodiscard]] float nearest_depth(std::uint32_t segment) const;

  /// The depths between the nearest and the farthest point in the view and before `limit` (view depth, one a pixel; or
  /// empty): nearly those of the fragments, known before them. O(points), parallel.
  [[nodiscard]] depth_range seen_depths(std::span<const float> limit) const;

  /// From end to end in pixels; an end nearer than the near plane is taken to lie on it.
  [[nodiscard]] float length_on_screen(std::uint32_t segment) const {
    const std::uint32_t i = fibres_.segment[segment];
    return glm::length(pixel_of(point_[i + 1]) - pixel_of(point_[i]));
  }

  [[nodiscard]] const strands& fibres() const { return fibres_; }
  [[nodiscard]] const view& from() const { return view_; }
  [[nodiscard]] const view_opacity& opacity() const { return opacity_; }

  /// Position, or any other per-point value, at a place on a segment.
  template <class T>
  [[nodiscard]] T mix(const big_array<T>& value, std::uint32_t segment, float along) const {
    return fibres_.mix(value, segment, along);
  }

 private:
  class sweep;
  using projected = projected_point<float>;

  /// What a segment leaves where the pixel's centre is (x, y).
  template <class Real>
  [[nodiscard, gnu::always_inline]] segment_in_pixel<Real> look(const projected_point<Real>& start,
                                                                const projected_point<Real>& end, Real x,
                                                                Real y) const {
    if (drawn_ == primitive::line) return line_in_pixel(start, end, x, y, view_, line_depths_, antialias_);
    return look_at(start, end, x, y, view_, antialias_);
  }

  [[nodiscard]] static glm::vec3 position_of(const projected& p) { return {p.x, p.y, p.z}; }
  [[nodiscard]] static glm::vec2 pixel_of(const projected& p) { return {p.pixel_x, p.pixel_y}; }

  /// The outline of a segment that reaches past the near plane or far beyond the view: a box or the whole view.
  [[nodiscard]] outline<float> wide_outline_of(std::uint32_t segment) const;

  const strands& fibres_;
  const view& view_;
  bool antialias_;
  primitive drawn_ = primitive::segment;
  line_depths line_depths_;
  float stretch_;
  view_opacity opacity_;
  big_array<projected> point_;
};

// ---------------------------------------------------------------------------------------------------------

// A fragment's depth is that of a point on the pixel's ray, which the fibre and the pixel's disc there reach.
inline float raster::nearest_depth(std::uint32_t segment) const {
  const std::uint32_t i = fibres_.segment[segment];
  const projected& a = point_[i];
  const projected& b = point_[i + 1];
  const float reach = std::max(a.radius, b.radius) + view_.cone.base;
  return (-std::max(a.z, b.z) - reach) / (1.0F + view_.cone.slope);
}

inline pixel_fragment raster::at(std::uint32_t segment, int x, int y) const {
  const std::uint32_t i = fibres_.segment[segment];
  const projected& a = point_[i];
  const projected& b = point_[i + 1];
  const auto found = look(a, b, static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  return {segment, found.depth, found.coverage, found.along};
}

}  // namespace pelage::frame
