// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/joint.hpp>

#include "frame/raster/outline.hpp"
#include "frame/scene/view.hpp"

namespace pelage::frame {

/// What a segment leaves in a pixel, as in pixel_fragment. Real: float, or a pack of floats for as many segments, each
/// with a pixel.
template <class Real>
struct segment_in_pixel {
  Real depth, coverage, along;
};

/// What it leaves where the pixel's centre is (x, y), in the pixels that are owned_by_segment(); elsewhere coverage 0.
template <class Real>
[[nodiscard, gnu::always_inline]] inline segment_in_pixel<Real> look_at(const projected_point<Real>& start,
                                                                        const projected_point<Real>& end, Real x,
                                                                        Real y, const view& from, bool antialias) {
  const Real zero(0.0F);
  const auto joint = [](const projected_point<Real>& p) {
    return strand_joint<Real>{{p.pixel_x, p.pixel_y}, {p.joint_x, p.joint_y}};
  };
  const Real owned = owned_by_segment(joint(start), joint(end), {x, y});

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
  share = select(owned > zero, share, zero);
  return {pair.along_ray, share, pair.along_segment};
}

}  // namespace pelage::frame
