// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/real_number.hpp>
#include <pelage/core/vector_math.hpp>

#include <glm/vec3.hpp>

namespace pelage::inline PELAGE_ABI {

/// Where a ray and a fibre's segment pass each other most closely.
template <real_number Real>
struct closest_pair {
  Real along_ray;      ///< the pseudo depth: position on the ray in lengths of its direction, [0, inf)
  Real along_segment;  ///< position on the segment, [0, 1] from its first end to its second
  Real distance;       ///< between the two points, length units, [0, inf)
};

/// The closest points of a ray and a segment. A ray that misses the fibre's axis has no hit point: the point of the
/// ray nearest to the axis stands for it, and its `along_ray` is the fragment's depth. [Yu12 §4.2]
///
/// `direction` need not be a unit vector but not 0: with direction.z = ±1 in view space, `along_ray` is view depth.
/// Ties: of a segment parallel to the ray, the point nearest to the ray's origin. A segment of length 0 is a point.
/// Points behind the origin are clamped to it. NaN in gives a NaN depth and distance; `along_segment` stays in [0, 1].
/// The distance is right within 8 ulp of the two ends' distances from the origin, added up; the depth is as
/// ill-conditioned as the angle between ray and segment is small. In float for directions of a length in [2⁻²⁰, 2³⁰]
/// and ends that lie [2⁻²⁰, 2³⁰] from the origin, in double [2⁻¹⁵⁰, 2²⁵⁰] for both; beyond, squares under- or overflow.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline closest_pair<Real> closest_points(const glm::vec<3, Real>& origin,
                                                                           const glm::vec<3, Real>& direction,
                                                                           const glm::vec<3, Real>& start,
                                                                           const glm::vec<3, Real>& end) noexcept;

/// Where across its width a ray meets a fibre: the h of bsdf/, [-1, 1], 0 on the axis. The fibre runs from `start` to
/// `end`, its tip; h is positive on the side of eye × x, with the eye at -direction and x along the fibre: seen from
/// +z, on the side of +y. `pair`: closest_points() of the same four. `radius`: (0, inf), in the same unit. Clamped:
/// beyond the fibre's edge, which a pixel's disc may cover from outside, -1 or 1. 0 for a ray along the fibre and a
/// segment of length 0; NaN gives 0. Right within the error of pair.distance over the radius, where the closest point
/// is an end of segment or ray that over the sine of the angle between them. Directions and ends as there, and the
/// segment's length times the direction's at least 2⁻⁷⁰ in float.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real offset_across(const glm::vec<3, Real>& origin,
                                                            const glm::vec<3, Real>& direction,
                                                            const glm::vec<3, Real>& start,
                                                            const glm::vec<3, Real>& end,
                                                            const closest_pair<Real>& pair, Real radius) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <real_number Real>
closest_pair<Real> closest_points(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction,
                                  const glm::vec<3, Real>& start, const glm::vec<3, Real>& end) noexcept {
  const glm::vec<3, Real> axis = end - start;
  const glm::vec<3, Real> offset = start - origin;
  const Real direction2 = dot_product(direction, direction);

  // Seen along the ray the segment is offset × d + s (axis × d): the least of that is the closest point. The cross
  // products keep the digits that d·d a·a - (d·a)² loses when the two are nearly parallel.
  const glm::vec<3, Real> offset_seen = cross_product(offset, direction);
  const glm::vec<3, Real> axis_seen = cross_product(axis, direction);
  const Real seen2 = dot_product(axis_seen, axis_seen);
  const Real end_on = select(dot_product(axis, direction) < Real(0), Real(1), Real(0));
  Real s = select(seen2 > Real(0), saturate((Real(0) - dot_product(offset_seen, axis_seen)) / seen2), end_on);
  Real t = dot_product(offset + s * axis, direction) / direction2;
  if (holds_for_any(t < Real(0))) {
    const Real axis2 = dot_product(axis, axis);
    const Real nearest = saturate((Real(0) - dot_product(offset, axis)) / axis2);
    s = select(t < Real(0), select(axis2 > Real(0), nearest, Real(0)), s);
    t = select(t < Real(0), Real(0), t);
  }
  const glm::vec<3, Real> gap = offset + s * axis - t * direction;
  return closest_pair<Real>{t, s, vector_length(gap)};
}

template <real_number Real>
Real offset_across(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction, const glm::vec<3, Real>& start,
                   const glm::vec<3, Real>& end, const closest_pair<Real>& pair, Real radius) noexcept {
  const glm::vec<3, Real> axis = end - start;
  const glm::vec<3, Real> side = cross_product(axis, direction);
  const glm::vec<3, Real> gap = (origin - start) + pair.along_ray * direction - pair.along_segment * axis;
  const Real h = dot_product(gap, side) / (vector_length(side) * radius);
  return select(h > Real(-1), select(h < Real(1), h, Real(1)), select(h < Real(0), Real(-1), Real(0)));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
