// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>

#include "frame/raster/outline.hpp"
#include "frame/scene/view.hpp"

namespace pelage::frame {

/// What a segment leaves in a pixel, as in pixel_fragment. Real: float, or a pack of floats for as many segments, each
/// with a pixel.
template <class Real>
struct segment_in_pixel {
  Real depth, coverage, along;
};

/// 1 for a segment that the view sees end on, so that the joints at its ends have no direction; else 0.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Real seen_end_on(const projected_point<Real>& start,
                                                          const projected_point<Real>& end) {
  const Real any_joint =
      absolute(start.joint_x) + absolute(start.joint_y) + absolute(end.joint_x) + absolute(end.joint_y);
  return select(any_joint > Real(0.0F), Real(0.0F), Real(1.0F));
}

/// What it leaves where the pixel's centre is (x, y); `end_on`: seen_end_on() of its ends. A pixel belongs to the
/// segment that lies between the lines through its two joints, on the first but not on the second; one seen end on has
/// no such lines and owns all that it reaches.
template <class Real>
[[nodiscard, gnu::always_inline]] inline segment_in_pixel<Real> look_at(const projected_point<Real>& start,
                                                                        const projected_point<Real>& end, Real end_on,
                                                                        Real x, Real y, const view& from,
                                                                        bool antialias) {
  const Real zero(0.0F);
  const auto past = [&](const projected_point<Real>& p) {
    return (x - p.pixel_x) * p.joint_x + (y - p.pixel_y) * p.joint_y;
  };
  const auto behind_start = past(start) < zero;
  const auto before_end = past(end) < end_on;

  const ray_from<Real> ray = from.ray(x, y);
  const closest_pair<Real> pair =
      closest_points(ray.origin, ray.direction, {start.x, start.y, start.z}, {end.x, end.y, end.z});
  const Real disc = Real(from.cone.base) + Real(from.cone.slope) * greatest(pair.along_ray, zero);
  const Real radius = start.radius + pair.along_segment * (end.radius - start.radius);
  Real share;
  if (antialias) {
    share = disc_strip_share(pair.distance, radius, disc);
  } else {
    share = select(greatest(radius, disc) < pair.distance, zero, Real(1.0F));
  }
  const Real axis_depth = zero - (start.z + pair.along_segment * (end.z - start.z));
  const Real near_plane(from.near_plane);
  share = select(pair.along_ray < near_plane, zero, select(axis_depth < near_plane, zero, share));
  share = select(behind_start, zero, select(before_end, share, zero));
  return {pair.along_ray, share, pair.along_segment};
}

}  // namespace pelage::frame
