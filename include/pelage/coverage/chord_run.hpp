// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/vector_math.hpp>
#include <pelage/coverage/segment_quad.hpp>

#include <glm/vec3.hpp>

#include <concepts>
#include <limits>

namespace pelage::inline PELAGE_ABI {

/// Neighbouring segments of a strand that one segment, their chord, may stand for: what a walk along the strand knows
/// of those that it has passed. Points are visited once and not kept; 17 numbers whatever the length. [After Imai & Iri
/// 1988 and Zhao & Saalfeld 1997, whose sector of directions is here a rectangle of slopes in space]
///
///     run = begin_chord(point[0], radius[0], tolerance[0]);
///     for (i = 1; i < count; ++i) {
///       if (!chord_reaches(run, point[i], radius[i], tolerance[i]) && i - 1 > kept) {
///         kept = i - 1;  // point i - 1 stays; so do the first and the last
///         run = begin_chord(point[kept], radius[kept], tolerance[kept]);
///       }
///       run = pass_point(run, point[i], radius[i], tolerance[i], radius_tolerance[i]);
///     }
///
/// Then each passed point p lies within its tolerance of the chord's point at the same place along `along`, and so does
/// each point of the segments between, within the tolerance that is linear between those of the ends; places along the
/// chord rise with those along the strand. The radius, linear along the chord, is within the radius tolerance of p's at
/// that place. Directions between the points are bounded by that alone. All by rounding more, some ulp of the distance
/// from the origin, and of the chord's length times what the tolerance is of the first segment's, where that is more.
/// Chords are as long as the walk can see: it does not go on past a point that no chord reaches.
template <std::floating_point Real>
struct chord_run {
  glm::vec<3, Real> start;  ///< the point where it begins
  glm::vec<3, Real> along;  ///< toward the first other point, unit but where squares underflow; 0 before there is one
  glm::vec<3, Real> side;   ///< unit, at right angles
  Real start_radius;        ///< the fibre's, there
  Real reach;               ///< of the last point passed, along `along`; -1 before, +inf: nothing goes on
  glm::vec<3, Real> least_slope;     ///< of a chord, per length along `along`: toward the side, toward along × side,
  glm::vec<3, Real> greatest_slope;  ///< and of the radius
};

/// A run that begins at a strand's point, with a fibre of this radius. `tolerance`: as in pass_point(); where it is
/// negative or NaN, the run reaches no further than the next point.
template <std::floating_point Real>
[[nodiscard]] chord_run<Real> begin_chord(const glm::vec<3, Real>& point, Real radius, Real tolerance) noexcept;

/// True if the chord from the run's start to this point may stand for the segments passed and the one that ends here;
/// always, whatever the tolerance, for the first
/// point after the start, unless its distance from there is infinite or NaN. Others must go on along the strand: one
/// that turns back, or lies on the start after another, is not reached, nor is one whose `tolerance` is negative or
/// NaN. NaN and infinities are never reached; a NaN radius that was passed bounds nothing.
template <std::floating_point Real>
[[nodiscard]] bool chord_reaches(const chord_run<Real>& run, const glm::vec<3, Real>& point, Real radius,
                                 Real tolerance) noexcept;

/// The run after a point that it reaches, or the first one. `tolerance`: how far from it the chord may pass, [0, inf),
/// in the points' unit; `radius_tolerance`: how far the radius there may be from its own, [0, inf). Where either is
/// negative or NaN, or the point is NaN, nothing is reached any more: the point stays. With a tolerance of 0 runs go on
/// along straight strands as far as rounding lets them.
template <std::floating_point Real>
[[nodiscard]] chord_run<Real> pass_point(const chord_run<Real>& run, const glm::vec<3, Real>& point, Real radius,
                                         Real tolerance, Real radius_tolerance) noexcept;

/// How far a point may move in space so that a perspective view shows it at most `error` pixels from where it was, but
/// for rounding, in the unit of depth: a tolerance for pass_point(). An orthographic view's is `error` over its pixels
/// per unit.
///
/// `error`: pixels, [0, inf). `depth`: view depth of the point, finite; -1 comes back where it is less than
/// `near_plane`, in (0, inf), or NaN: a segment that crosses the plane stays. `scale`: pixels per unit of tangent, (0,
/// inf). `slant`: length of a pixel's ray with a view depth of 1, the longest of the view, [1, inf); where either place
/// is outside of the view, the promise is for the other.
template <std::floating_point Real>
[[nodiscard]] Real screen_tolerance(Real error, Real depth, Real near_plane, Real scale, Real slant) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
chord_run<Real> begin_chord(const glm::vec<3, Real>& point, Real radius, Real tolerance) noexcept {
  const Real steepest = std::numeric_limits<Real>::max();
  const Real greatest_slope = tolerance >= Real(0) ? steepest : -steepest;  // or no slope at all
  const glm::vec<3, Real> zero = glm::vec<3, Real>(Real(0));
  return chord_run<Real>{
      point, zero, zero, radius, Real(-1), glm::vec<3, Real>(-steepest), glm::vec<3, Real>(greatest_slope)};
}

namespace detail {

/// A point from the start of the run: toward the side, toward along × side, and the radius.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> across_run(const chord_run<Real>& run, const glm::vec<3, Real>& way,
                                           Real radius) noexcept {
  const glm::vec<3, Real> third = cross_product(run.along, run.side);
  return glm::vec<3, Real>(dot_product(way, run.side), dot_product(way, third), radius - run.start_radius);
}

}  // namespace detail

template <std::floating_point Real>
bool chord_reaches(const chord_run<Real>& run, const glm::vec<3, Real>& point, Real radius, Real tolerance) noexcept {
  const glm::vec<3, Real> way = point - run.start;
  const Real place = dot_product(way, run.along);
  const glm::vec<3, Real> across = detail::across_run(run, way, radius);
  const glm::vec<3, Real> low = run.least_slope * place;
  const glm::vec<3, Real> high = run.greatest_slope * place;
  const bool within_side = across.x >= low.x && across.x <= high.x;
  const bool within_third = across.y >= low.y && across.y <= high.y;
  const bool within_radius = across.z >= low.z && across.z <= high.z;
  const bool is_first = run.reach < Real(0) && place == Real(0);
  return is_first || (place > run.reach && tolerance >= Real(0) && within_side && within_third && within_radius);
}

template <std::floating_point Real>
chord_run<Real> pass_point(const chord_run<Real>& run, const glm::vec<3, Real>& point, Real radius, Real tolerance,
                           Real radius_tolerance) noexcept {
  chord_run<Real> next = run;
  const glm::vec<3, Real> way = point - run.start;
  const Real way_length = vector_length(way);
  if (dot_product(run.along, run.along) == Real(0) && way_length > Real(0)) {
    next.along = way / way_length;
    next.side = any_normal(next.along);
  }
  const Real place = dot_product(way, next.along);
  const bool goes_on = place >= Real(0) && tolerance >= Real(0) && radius_tolerance >= Real(0);
  next.reach = goes_on ? place : std::numeric_limits<Real>::infinity();
  if (goes_on && place > Real(0)) {
    const Real each = tolerance * Real(0.70710678118654752);  // both ways across together are the tolerance
    const glm::vec<3, Real> room = glm::vec<3, Real>(each, each, radius_tolerance);
    const glm::vec<3, Real> across = detail::across_run(next, way, radius);
    const glm::vec<3, Real> low = (across - room) / place;
    const glm::vec<3, Real> high = (across + room) / place;
    next.least_slope = glm::max(next.least_slope, low);
    next.greatest_slope = glm::min(next.greatest_slope, high);
  }
  return next;
}

template <std::floating_point Real>
Real screen_tolerance(Real error, Real depth, Real near_plane, Real scale, Real slant) noexcept {
  return depth >= near_plane ? depth * (error / (scale * slant + error)) : Real(-1);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
