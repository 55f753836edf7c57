// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/ray_cone.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <concepts>

namespace pelage {

/// The quad to rasterise for one segment of a fibre, in view space: eye at the origin, looking down -z, y up.
template <std::floating_point Real>
struct segment_quad {
  std::array<glm::vec<3, Real>, 4> corner;  ///< round the quad, two at the start and two at the end
  bool visible;                             ///< false: nothing in front of the near plane, corners are all 0
};

/// Widens a segment to a quad that faces the eye, by the fibre's radius plus `margin` pixels to the sides and past
/// the ends: every pixel whose disc the fibre can touch has its centre inside, and few others. [Yu12 §4]
///
/// `start`, `end`: view space. What lies nearer than the plane z = -near_plane is cut off; near_plane in (0, inf),
/// for an orthographic cone any number. `fibre_radius`: [0, inf). `cone`: the pixel's; its disc must not be wider
/// than a pixel. `margin`: pixels, [0.5, inf), 2 where nothing else is known.
/// A segment parallel to the view ray, or of length 0, gives a square that faces the eye. With perspective, a
/// fibre that reaches the eye gives a quad without bound on its size. NaN or infinite ends: not visible.
template <std::floating_point Real>
[[nodiscard]] segment_quad<Real> expand_segment(const glm::vec<3, Real>& start, const glm::vec<3, Real>& end,
                                                Real fibre_radius, ray_cone<Real> cone, Real near_plane,
                                                Real margin) noexcept;

/// How far to go from a point of the axis, at right angles to the view ray, to clear the fibre and the margin.
template <std::floating_point Real>
[[nodiscard]] Real half_width_at(const glm::vec<3, Real>& point, Real fibre_radius, ray_cone<Real> cone,
                                 Real margin) noexcept;

/// A unit vector at right angles to a unit vector.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> any_normal(const glm::vec<3, Real>& direction) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
Real half_width_at(const glm::vec<3, Real>& point, Real fibre_radius, ray_cone<Real> cone, Real margin) noexcept {
  const Real pixels = Real(2) * margin * radius_at(cone, -point.z);
  if (cone.slope == Real(0)) {
    return fibre_radius + pixels;
  }
  // The cone of sight that touches a sphere is wider than the sphere's radius at its centre.
  const Real distance2 = glm::dot(point, point);
  const Real least = Real(1e-6) * distance2;
  const Real clear = distance2 - fibre_radius * fibre_radius;
  return fibre_radius * std::sqrt(distance2 / (clear > least ? clear : least)) + pixels;
}

template <std::floating_point Real>
glm::vec<3, Real> any_normal(const glm::vec<3, Real>& direction) noexcept {
  const bool along_x = direction.x * direction.x > Real(0.5);
  const glm::vec<3, Real> other =
      along_x ? glm::vec<3, Real>(Real(0), Real(1), Real(0)) : glm::vec<3, Real>(Real(1), Real(0), Real(0));
  return glm::normalize(glm::cross(direction, other));
}

template <std::floating_point Real>
segment_quad<Real> expand_segment(const glm::vec<3, Real>& start, const glm::vec<3, Real>& end, Real fibre_radius,
                                  ray_cone<Real> cone, Real near_plane, Real margin) noexcept {
  const glm::vec<3, Real> zero = glm::vec<3, Real>(Real(0));
  segment_quad<Real> quad = segment_quad<Real>{std::array<glm::vec<3, Real>, 4>{zero, zero, zero, zero}, false};
  const glm::vec<3, Real> span = end - start;
  const Real check = (glm::dot(start, start) + glm::dot(end, end)) * Real(0);
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
  const glm::vec<3, Real> first_view = perspective ? glm::normalize(first) : ahead;
  const glm::vec<3, Real> last_view = perspective ? glm::normalize(last) : ahead;

  // One normal of the plane through the eye and the segment serves both ends; it vanishes where the segment is
  // seen end on, and any side will do there.
  const glm::vec<3, Real> plane = glm::cross(first_view, perspective ? last_view : span);
  const Real plane_length = glm::length(plane);
  const Real end_on = perspective ? Real(1e-6) : Real(1e-6) * glm::length(span);
  const glm::vec<3, Real> side = plane_length > end_on ? plane / plane_length : any_normal(first_view);
  const glm::vec<3, Real> first_along = glm::cross(side, first_view);
  const glm::vec<3, Real> last_along = glm::cross(side, last_view);

  // The wider of the two ends, as seen, serves both: a near end can hide a far one whole.
  Real first_width = half_width_at(first, fibre_radius, cone, margin);
  Real last_width = half_width_at(last, fibre_radius, cone, margin);
  if (perspective) {
    const Real first_seen = first_width / glm::length(first);
    const Real last_seen = last_width / glm::length(last);
    const Real seen = first_seen > last_seen ? first_seen : last_seen;
    first_width = seen * glm::length(first);
    last_width = seen * glm::length(last);
  }

  quad.corner[0] = first - first_width * first_along - first_width * side;
  quad.corner[1] = first - first_width * first_along + first_width * side;
  quad.corner[2] = last + last_width * last_along + last_width * side;
  quad.corner[3] = last + last_width * last_along - last_width * side;
  quad.visible = true;
  return quad;
}

}  // namespace pelage
