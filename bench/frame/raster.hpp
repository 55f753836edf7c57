// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/coverage_lanes.hpp>
#include <pelage/coverage/disc_strip.hpp>

#include <glm/glm.hpp>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "frame/strands.hpp"
#include "frame/view.hpp"

namespace pelage::frame {

/// What a segment leaves in a pixel.
struct touch {
  float depth;     ///< view depth of the point of the pixel's ray nearest to the fibre's axis
  float coverage;  ///< share of the pixel's disc, [0, 1]; 0: the segment is not in this pixel
  float along;     ///< position on the segment, [0, 1]
};

/// All strands as one view sees them, and the fragments that they leave in its pixels. The same question asked
/// twice gives the same bits, so that a fragment's depth and coverage need not be kept: its id finds them again.
///
/// Where two segments of a strand meet, the line through the joint at right angles to the strand divides the pixels
/// between them, so that none is counted twice. Beside segments that cross the near plane the line is an estimate.
class raster {
 public:
  /// `antialias` off: a pixel is covered whole if the axis crosses its disc or the fibre its centre, else not at all.
  /// Both references must outlive the raster. O(points), parallel.
  raster(const strands& fibres, const view& from, bool antialias);

  /// The fragment of a segment in a pixel of the view.
  [[nodiscard]] touch at(std::uint32_t segment, int x, int y) const;

  /// Calls `visit(x, y, touch)` for each pixel of `clip` that the segment covers in part.
  template <class Visit>
  void for_each(std::uint32_t segment, const pixel_rect& clip, Visit&& visit) const;

  /// Asks the processor to load what for_each() will read.
  void prefetch(std::uint32_t segment) const {
    const projected* const point = &point_[fibres_.segment[segment]];
    __builtin_prefetch(point);
    __builtin_prefetch(point + 1);
  }

  /// The pixels of the view that the segment may touch; empty (x0 >= x1 or y0 >= y1) when there are none.
  [[nodiscard]] pixel_rect bounds(std::uint32_t segment) const { return outline_of(segment).box; }

  /// A view depth that none of the segment's fragments lies before, rounding apart.
  [[nodiscard]] float nearest_depth(std::uint32_t segment) const;

  /// From end to end in pixels; an end nearer than the near plane is taken to lie on it.
  [[nodiscard]] float length_on_screen(std::uint32_t segment) const {
    const std::uint32_t i = fibres_.segment[segment];
    return glm::length(point_[i + 1].pixel - point_[i].pixel);
  }

  [[nodiscard]] const strands& fibres() const { return fibres_; }
  [[nodiscard]] const view& from() const { return view_; }

  /// Position, or any other per-point value, at a place on a segment.
  template <class T>
  [[nodiscard]] T mix(const std::vector<T>& value, std::uint32_t segment, float along) const {
    return fibres_.mix(value, segment, along);
  }

 private:
  static constexpr int width = lane_width();

  /// A strand's point as the view sees it, together what a fragment needs.
  struct alignas(32) projected {
    glm::vec3 position;  ///< view space
    float radius;
    glm::vec2 pixel;  ///< pixel coordinates
    glm::vec2 joint;  ///< the strand's direction on the screen, any length
  };

  /// The pixels that a segment may touch: those of a box, and in each of its rows those near a slanted line. A
  /// pixel's centre lies at most `half` beside the line's crossing with its row, (x, y) + n (slope, 1).
  struct outline {
    pixel_rect box;
    float x, y, slope, half;
  };
  [[nodiscard]] outline outline_of(std::uint32_t segment) const;

  /// The same for segments that reach past the near plane or far beyond the view: a box or the whole view.
  [[nodiscard]] outline wide_outline_of(std::uint32_t segment) const;

  /// The pixels of the view whose centres lie in a rectangle.
  [[nodiscard]] pixel_rect centres_in(const glm::vec2& lower, const glm::vec2& upper) const;

  /// The segment's touches in pixels with these centres.
  struct touches {
    lanes<width> depth, coverage, along;
  };
  [[nodiscard]] static lanes<width> iota();
  [[nodiscard]] touches at_centres(std::uint32_t segment, lanes<width> x, lanes<width> y) const;

  const strands& fibres_;
  const view& view_;
  bool antialias_;
  float stretch_;  ///< from gaps beside a ray to distances on the screen
  std::vector<projected> point_;
};

// ---------------------------------------------------------------------------------------------------------

/// The first pixel of [low, high] whose centre does not lie before x, which may lie beyond any int.
[[nodiscard]] inline int first_centre_from(float x, int low, int high) {
  return static_cast<int>(std::ceil(std::clamp(x - 0.5F, static_cast<float>(low), static_cast<float>(high))));
}

template <class Visit>
void raster::for_each(std::uint32_t segment, const pixel_rect& clip, Visit&& visit) const {
  const outline near = outline_of(segment);
  const int y0 = std::max(near.box.y0, clip.y0);
  const int y1 = std::min(near.box.y1, clip.y1);
  const int x0 = std::max(near.box.x0, clip.x0);
  const int x1 = std::min(near.box.x1, clip.x1);
  if (x0 >= x1) return;
  alignas(64) float x_of[2 * width];
  alignas(64) float y_of[2 * width];
  int waiting = 0;
  const auto visit_first = [&](int count) {
    const touches found = at_centres(segment, lanes<width>::load(x_of), lanes<width>::load(y_of));
    float depth[width];
    float coverage[width];
    float along[width];
    found.depth.store(depth);
    found.coverage.store(coverage);
    found.along.store(along);
    std::uint32_t left = bits(found.coverage > lanes<width>(0.0F)) & ((1U << count) - 1U);
    for (; left != 0; left &= left - 1U) {
      const int k = std::countr_zero(left);
      visit(static_cast<int>(x_of[k]), static_cast<int>(y_of[k]), touch{depth[k], coverage[k], along[k]});
    }
  };
  for (int y = y0; y < y1; ++y) {
    const float centre = static_cast<float>(y) + 0.5F;
    const float crossing = near.x + (centre - near.y) * near.slope;
    const int right = first_centre_from(crossing + near.half, x0, x1);
    for (int x = first_centre_from(crossing - near.half, x0, x1); x < right; x += width) {
      (iota() + lanes<width>(static_cast<float>(x) + 0.5F)).store(x_of + waiting);
      lanes<width>(centre).store(y_of + waiting);
      waiting += std::min(right - x, width);
      if (waiting < width) continue;
      visit_first(width);
      waiting -= width;
      lanes<width>::load(x_of + width).store(x_of);
      lanes<width>::load(y_of + width).store(y_of);
    }
  }
  if (waiting > 0) visit_first(waiting);
}

inline lanes<raster::width> raster::iota() {
  lanes<width> numbers;
  for (int k = 0; k < width; ++k)
    numbers.lane[k] = static_cast<float>(k);
  return numbers;
}

inline raster::touches raster::at_centres(std::uint32_t segment, lanes<width> x, lanes<width> y) const {
  using pack = lanes<width>;
  const std::uint32_t i = fibres_.segment[segment];
  const projected& a = point_[i];
  const projected& b = point_[i + 1];
  const auto past = [&](const projected& p) {
    return (x - pack(p.pixel.x)) * pack(p.joint.x) + (y - pack(p.pixel.y)) * pack(p.joint.y);
  };
  const pack zero(0.0F);
  const lane_mask<width> behind_start = past(a) < zero;
  const lane_mask<width> before_end = past(b) < zero;
  const bool seen_end_on = a.joint == glm::vec2(0.0F) && b.joint == glm::vec2(0.0F);

  const pack scale(view_.scale);
  const lane_points<width> across{(x - pack(0.5F * static_cast<float>(view_.width))) / scale,
                                  (pack(0.5F * static_cast<float>(view_.height)) - y) / scale, zero};
  const lane_points<width> nowhere{zero, zero, zero};
  const lane_points<width> origin = view_.perspective ? nowhere : across;
  const pack ahead(-1.0F);
  const lane_points<width> direction =
      view_.perspective ? lane_points<width>{across.x, across.y, ahead} : lane_points<width>{zero, zero, ahead};
  const glm::vec3& start = a.position;
  const glm::vec3& end = b.position;
  const closest_lanes<width> pair =
      closest_points(origin, direction, lane_points<width>{pack(start.x), pack(start.y), pack(start.z)},
                     lane_points<width>{pack(end.x), pack(end.y), pack(end.z)});

  const pack disc =
      pack(view_.cone.base) + pack(view_.cone.slope) * select(pair.along_ray > zero, pair.along_ray, zero);
  const float radius_change = b.radius - a.radius;
  const pack radius = pack(a.radius) + pair.along_segment * pack(radius_change);
  pack share;
  if (antialias_) {
    share = disc_strip_share(pair.distance, radius, disc);
  } else {
    share = select(select(radius > disc, radius, disc) < pair.distance, zero, pack(1.0F));
  }
  const pack axis_depth = zero - (pack(start.z) + pair.along_segment * pack(end.z - start.z));
  const pack near_plane(view_.near_plane);
  share = select(pair.along_ray < near_plane, zero, select(axis_depth < near_plane, zero, share));
  if (!seen_end_on) share = select(behind_start, zero, select(before_end, share, zero));
  return {pair.along_ray, share, pair.along_segment};
}

// A fragment's depth is that of a point on the pixel's ray, which the fibre and the pixel's disc there reach.
inline float raster::nearest_depth(std::uint32_t segment) const {
  const std::uint32_t i = fibres_.segment[segment];
  const projected& a = point_[i];
  const projected& b = point_[i + 1];
  const float reach = std::max(a.radius, b.radius) + view_.cone.base;
  return (-std::max(a.position.z, b.position.z) - reach) / (1.0F + view_.cone.slope);
}

inline touch raster::at(std::uint32_t segment, int x, int y) const {
  const std::uint32_t i = fibres_.segment[segment];
  const projected& a = point_[i];
  const projected& b = point_[i + 1];
  const glm::vec2 centre(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  const bool behind_start = glm::dot(centre - a.pixel, a.joint) < 0.0F;
  const bool before_end = glm::dot(centre - b.pixel, b.joint) < 0.0F;
  if (behind_start || !before_end) {
    const bool seen_end_on = a.joint == glm::vec2(0.0F) && b.joint == glm::vec2(0.0F);
    if (!seen_end_on) return touch{0.0F, 0.0F, 0.0F};
  }

  const view_ray ray = view_.ray(centre);
  const closest_pair<float> pair = closest_points(ray.origin, ray.direction, a.position, b.position);
  const float disc = radius_at(view_.cone, pair.along_ray);
  const float radius = a.radius + pair.along_segment * (b.radius - a.radius);
  const float share = antialias_ ? disc_strip_share(pair.distance, radius, disc)
                                 : (pair.distance <= std::max(radius, disc) ? 1.0F : 0.0F);
  const float axis_depth = -(a.position.z + pair.along_segment * (b.position.z - a.position.z));
  const bool in_front = std::min(pair.along_ray, axis_depth) >= view_.near_plane;
  return touch{pair.along_ray, in_front ? share : 0.0F, pair.along_segment};
}

}  // namespace pelage::frame
