// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/segment_quad.hpp>

#include <glm/glm.hpp>
#include <algorithm>
#include <array>
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

  /// The pixels of the view that the segment may touch; empty (x0 >= x1 or y0 >= y1) when there are none.
  [[nodiscard]] pixel_rect bounds(std::uint32_t segment) const;

  [[nodiscard]] const strands& fibres() const { return fibres_; }
  [[nodiscard]] const view& from() const { return view_; }

  /// Position, or any other per-point value, at a place on a segment.
  template <class T>
  [[nodiscard]] T mix(const std::vector<T>& value, std::uint32_t segment, float along) const {
    return fibres_.mix(value, segment, along);
  }

 private:
  /// A quad on the screen. `bounded` is false when it reaches past the near plane and may be anywhere.
  struct outline {
    std::array<glm::vec2, 4> corner;
    bool visible, bounded;
  };
  [[nodiscard]] outline outline_of(std::uint32_t segment) const;

  const strands& fibres_;
  const view& view_;
  bool antialias_;
  std::vector<glm::vec3> position_;  ///< per point, view space
  std::vector<glm::vec2> pixel_;     ///< per point, pixel coordinates
  std::vector<glm::vec2> joint_;     ///< per point, the strand's direction on the screen, any length
};

// ---------------------------------------------------------------------------------------------------------

/// The first pixel of [low, high] whose centre does not lie before x; quads may reach beyond any int.
[[nodiscard]] inline int first_centre_from(float x, int low, int high) {
  return static_cast<int>(std::ceil(std::clamp(x - 0.5F, static_cast<float>(low), static_cast<float>(high))));
}

template <class Visit>
void raster::for_each(std::uint32_t segment, const pixel_rect& clip, Visit&& visit) const {
  const outline quad = outline_of(segment);
  if (!quad.visible) return;
  int y0 = clip.y0;
  int y1 = clip.y1;
  if (quad.bounded) {
    const auto [low, high] = std::minmax({quad.corner[0].y, quad.corner[1].y, quad.corner[2].y, quad.corner[3].y});
    y0 = first_centre_from(low, clip.y0, clip.y1);
    y1 = first_centre_from(high, clip.y0, clip.y1);
  }
  for (int y = y0; y < y1; ++y) {
    const float centre = static_cast<float>(y) + 0.5F;
    float left = quad.bounded ? 1e30F : -1e30F;
    float right = -left;
    for (std::size_t k = 0; k < 4 && quad.bounded; ++k) {
      const glm::vec2& a = quad.corner[k];
      const glm::vec2& b = quad.corner[(k + 1) % 4];
      if ((a.y <= centre) == (b.y <= centre)) continue;
      const float x = a.x + (centre - a.y) / (b.y - a.y) * (b.x - a.x);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int x0 = first_centre_from(left, clip.x0, clip.x1);
    const int x1 = first_centre_from(right, clip.x0, clip.x1);
    for (int x = x0; x < x1; ++x) {
      const touch t = at(segment, x, y);
      if (t.coverage > 0.0F) visit(x, y, t);
    }
  }
}

inline touch raster::at(std::uint32_t segment, int x, int y) const {
  const std::uint32_t i = fibres_.segment[segment];
  const glm::vec2 centre(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  const bool behind_start = glm::dot(centre - pixel_[i], joint_[i]) < 0.0F;
  const bool before_end = glm::dot(centre - pixel_[i + 1], joint_[i + 1]) < 0.0F;
  if (behind_start || !before_end) {
    const bool seen_end_on = joint_[i] == glm::vec2(0.0F) && joint_[i + 1] == glm::vec2(0.0F);
    if (!seen_end_on) return touch{0.0F, 0.0F, 0.0F};
  }

  const view_ray ray = view_.ray(centre);
  const closest_pair<float> pair = closest_points(ray.origin, ray.direction, position_[i], position_[i + 1]);
  const float disc = radius_at(view_.cone, pair.along_ray);
  const float radius = mix(fibres_.radius, segment, pair.along_segment);
  const float share = antialias_ ? disc_strip_share(pair.distance, radius, disc)
                                 : (pair.distance <= std::max(radius, disc) ? 1.0F : 0.0F);
  const float axis_depth = -mix(position_, segment, pair.along_segment).z;
  const bool in_front = std::min(pair.along_ray, axis_depth) >= view_.near_plane;
  return touch{pair.along_ray, in_front ? share : 0.0F, pair.along_segment};
}

}  // namespace pelage::frame
