// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/vector_math.hpp>
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/ray_cone.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// The quad to rasterise for one segment of a fibre, in view space: eye at the origin, looking down -z, y up.
template <std::floating_point Real>
struct segment_quad {
  std::array<glm::vec<3, Real>, 4> corner;  ///< round the quad, two at the start and two at the end
  bool visible;                             ///< false: nothing in front of the near plane, corners are all 0
};

/// Widens a segment to a quad that faces the eye, by the fibre's radius plus `margin` discs to the sides and past
/// the ends: every pixel whose disc the fibre can touch has its centre inside, and few others.
/// [Yu12 §4.1, which moves the edges of the projected quad by 2 pixels; here corners are moved in space, so that it
/// holds for wide fibres near the eye and past the ends, too]
///
/// `start`, `end`: view space. What lies nearer than the plane z = -near_plane is cut off; near_plane in (0, inf),
/// for an orthographic cone any number. `fibre_radius`: [0, inf). `cone`: the pixel's, slope in [0, 1).
/// `margin`: widths of its disc, [0.5, inf), 2 where nothing else is known.
/// A segment parallel to the view ray, or of length 0, gives a square that faces the eye. Corners may lie nearer
/// than the near plane. NaN or infinite ends or radius: not visible.
/// With perspective the promise holds while quad and eye span less than 170°: a fibre nearer to the eye than a few
/// of its own radii covers a part of the sky that no quad can.
template <std::floating_point Real>
[[nodiscard]] segment_quad<Real> expand_segment(const glm::vec<3, Real>& start, const glm::vec<3, Real>& end,
                                                Real fibre_radius, ray_cone<Real> cone, Real near_plane,
                                                Real margin) noexcept;

// ---------------------------------------------------------------------------------------------------------

/// What the fibre and the margin take up round a point of the axis at this view depth.
template <std::floating_point Real>
[[nodiscard]] Real reach_at(Real depth, Real fibre_radius, ray_cone<Real> cone, Real margin) noexcept {
  // A pixel's disc may lie deeper than the point it touches by up to this very reach, and is the wider for it.
  return (fibre_radius + Real(2) * margin * radius_at(cone, depth)) / (Real(1) - cone.slope);
}

/// How much farther the cone of sight that touches a ball reaches beside the ball's centre than the ball itself.
/// `reach`: the ball's radius over the distance of its centre from the eye, [0, inf). At most 1000, as from 1 on.
template <std::floating_point Real>
[[nodiscard]] Real tangent_stretch(Real reach) noexcept {
  const Real cosine2 = (Real(1) - reach) * (Real(1) + reach);
  return cosine2 > Real(1e-6) ? Real(1) / std::sqrt(cosine2) : Real(1000);
}

/// A unit vector at right angles to a unit vector.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> any_normal(const glm::vec<3, Real>& direction) noexcept {
  const bool along_x = direction.x * direction.x > Real(0.5);
  const glm::vec<3, Real> other =
      along_x ? glm::vec<3, Real>(Real(0), Real(1), Real(0)) : glm::vec<3, Real>(Real(1), Real(0), Real(0));
  return unit_vector(cross_product(direction, other));
}

template <std::floating_point Real>
segment_quad<Real> expand_segment(const glm::vec<3, Real>& start, const glm::vec<3, Real>& end, Real fibre_radius,
                                  ray_cone<Real> cone, Real near_plane, Real margin) noexcept {
  const glm::vec<3, Real> zero = glm::vec<3, Real>(Real(0));
  segment_quad<Real> quad = segment_quad<Real>{std::array<glm::vec<3, Real>, 4>{zero, zero, zero, zero}, false};
  const glm::vec<3, Real> span = end - start;
  const Real check = (dot_product(start, start) + dot_product(end, end) + fibre_radius) * Real(0);
  const bool start_in = -start.z >= near_plane;
  const bool end_in = -end.z >= near_plane;
  if (check != Real(0) || (!start_in && !end_in)) {
    return quad;
  }

  const Real cut = (-near_plane - start.z) / span.z;
  const glm::vec<3, Real> crossing = glm::vec<3, Real>(start.x + cut * span.x, start.y + cut * span.y, -near_plane);
  const glm::vec<3, Real> first = start_in ? start : crossing;
  const glm::vec<3, Real> last = end_in ? end : crossing;

  const glm::vec<3, Real> ahead = glm::vec<3, Real>(Real(0), Real(0), Real(-1));
  const bool perspective = cone.slope > Real(0);
  const Real first_distance = perspective ? vector_length(first) : Real(1);
  const Real last_distance = perspective ? vector_length(last) : Real(1);
  const glm::vec<3, Real> first_view = perspective ? first / first_distance : ahead;
  const glm::vec<3, Real> last_view = perspective ? last / last_distance : ahead;

  // One normal of the plane through the eye and the segment serves both ends; it vanishes where the segment is
  // seen end on, and any side will do there. Where it is short, rounding has tilted it toward the view.
  const glm::vec<3, Real> plane = cross_product(first_view, perspective ? last_view : span);
  const Real plane_length = vector_length(plane);
  const Real end_on = perspective ? Real(1e-6) : Real(1e-18);
  const glm::vec<3, Real> upright = plane - dot_product(plane, first_view) * first_view;
  const glm::vec<3, Real> side = plane_length > end_on ? unit_vector(upright) : any_normal(first_view);
  const glm::vec<3, Real> first_along = cross_product(side, first_view);
  const glm::vec<3, Real> last_along = cross_product(side, last_view);

  // The wider of the two ends, as seen, serves both: a near end can hide a far one whole. What lies between them is
  // no wider, as distance is convex, except for the stretch, which is greatest where the axis is nearest to the eye.
  const Real first_seen = reach_at(-first.z, fibre_radius, cone, margin) / first_distance;
  const Real last_seen = reach_at(-last.z, fibre_radius, cone, margin) / last_distance;
  Real seen = first_seen > last_seen ? first_seen : last_seen;
  Real past = seen;
  if (perspective) {
    // Of a ray backwards from the eye, that is, of the eye itself.
    const Real nearest = closest_points(zero, -ahead, first, last).distance;
    seen = seen * tangent_stretch(reach_at(nearest, fibre_radius, cone, margin) / nearest);
    // Ends that lie far apart, seen from the eye, must not go round behind it.
    const Real room = Real(0.9) * (Real(1) + dot_product(first_view, last_view));
    past = seen * plane_length > room ? room / plane_length : seen;
  }

  const Real first_width = seen * first_distance;
  const Real last_width = seen * last_distance;
  const glm::vec<3, Real> first_tip = first - past * first_distance * first_along;
  const glm::vec<3, Real> last_tip = last + past * last_distance * last_along;
  quad.corner[0] = first_tip - first_width * side;
  quad.corner[1] = first_tip + first_width * side;
  quad.corner[2] = last_tip + last_width * side;
  quad.corner[3] = last_tip - last_width * side;
  quad.visible = true;
  return quad;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
