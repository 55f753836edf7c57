// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/longitudinal.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/vector_math.hpp>
#include <pelage/coverage/segment_quad.hpp>

#include <glm/vec3.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// From a ray tracer's hit on a curve to what the lobes take: h with its sign, and directions in the fibre's frame.
/// offset_across() has h from closest_points(). A ray that misses the fibre has no h, as most through the middle of a
/// pixel wider than the fibre: evaluate_chiang_far() is for these.

/// Right-handed, of unit vectors: x along the fibre, y across it on the eye's side, so that the eye's azimuth φ is 0.
template <std::floating_point Real>
struct fibre_frame {
  glm::vec<3, Real> x, y, z;
};

/// A hit as the lobes see it.
template <std::floating_point Real>
struct fibre_hit {
  Real h;                     ///< where the ray meets the width, [-1, 1], positive on the side of eye × x: of -z
  Real gamma;                 ///< asin h, the angle between the surface's normal and y, [-π/2, π/2]
  Real theta;                 ///< the eye's inclination, [-π/2, π/2], positive towards x
  fibre_frame<Real> frame;    ///< the same for every light at this hit
  fibre_direction<Real> eye;  ///< of -direction, for view_chiang()
};

/// The hit of a ray with a fibre of radius (0, inf) about an axis. `offset`: from any point of the axis near the hit to
/// any point of the ray near it, in the radius's unit. `direction`, from the eye on, and `tangent`, to the fibre's tip:
/// of a length in [2⁻⁶⁰, 2⁶⁰] in float.
///
/// A ray within 1e-6 radians of the fibre's direction counts as along it: h = 0 and y is any_normal(x). A tangent of
/// length 0 (a point's sphere) is taken across the ray, with h = 0. h beyond the width, as rounding or a taper gives
/// it, is clamped, radius 0 gives -1, 0 or 1, and NaN 0. Error of h: about 4 ulp of |offset|/radius over cos θ.
template <std::floating_point Real>
[[nodiscard]] inline fibre_hit<Real> fibre_hit_of(const glm::vec<3, Real>& offset, const glm::vec<3, Real>& direction,
                                                  const glm::vec<3, Real>& tangent, Real radius) noexcept;

/// The hit of a ray with a segment whose radius goes linearly from one end to the other: a cylinder, a cone or a
/// linear swept sphere. The radius is that at the foot of `hit` on the axis; on a cap, beyond an end, that of the end.
/// A segment of length 0 is the point's sphere above, of the radius at `start`.
template <std::floating_point Real>
[[nodiscard]] inline fibre_hit<Real> fibre_hit_on_segment(const glm::vec<3, Real>& hit,
                                                          const glm::vec<3, Real>& direction,
                                                          const glm::vec<3, Real>& start, const glm::vec<3, Real>& end,
                                                          Real start_radius, Real end_radius) noexcept;

/// A unit vector of the scene in the frame, for fibre_direction_of(); and back, for what a sampler drew.
template <std::floating_point Real>
[[nodiscard]] inline glm::vec<3, Real> into_frame(const fibre_frame<Real>& frame, const glm::vec<3, Real>& w) noexcept {
  return glm::vec<3, Real>(dot_product(w, frame.x), dot_product(w, frame.y), dot_product(w, frame.z));
}
template <std::floating_point Real>
[[nodiscard]] inline glm::vec<3, Real> out_of_frame(const fibre_frame<Real>& frame,
                                                    const glm::vec<3, Real>& w) noexcept {
  return w.x * frame.x + w.y * frame.y + w.z * frame.z;
}

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
fibre_hit<Real> fibre_hit_of(const glm::vec<3, Real>& offset, const glm::vec<3, Real>& direction,
                             const glm::vec<3, Real>& tangent, Real radius) noexcept {
  const glm::vec<3, Real> onward = unit_vector(direction);
  const bool point = !(dot_product(tangent, tangent) > Real(0));
  const glm::vec<3, Real> x = point ? any_normal(onward) : unit_vector(tangent);
  const glm::vec<3, Real> side = cross_product(x, onward);
  const Real cosine = vector_length(side);
  const bool end_on = !(cosine > Real(1e-6));

  // y crosses x and the sides at full precision however small the angle between x and the ray is.
  const glm::vec<3, Real> y = end_on ? any_normal(x) : unit_vector(cross_product(x, side));
  fibre_hit<Real> result;
  result.frame = fibre_frame<Real>{x, y, cross_product(x, y)};
  const Real h = point || end_on ? Real(0) : dot_product(offset, side) / (cosine * radius);
  result.h = select(h > Real(-1), select(h < Real(1), h, Real(1)), select(h < Real(0), Real(-1), Real(0)));
  result.gamma = angle_of_sine(result.h);
  const Real sine = Real(0) - dot_product(x, onward);
  result.theta = angle_of(sine, cosine);
  result.eye = fibre_direction<Real>{sine, cosine, Real(1), Real(0)};
  return result;
}

template <std::floating_point Real>
fibre_hit<Real> fibre_hit_on_segment(const glm::vec<3, Real>& hit, const glm::vec<3, Real>& direction,
                                     const glm::vec<3, Real>& start, const glm::vec<3, Real>& end, Real start_radius,
                                     Real end_radius) noexcept {
  const glm::vec<3, Real> axis = end - start;
  const glm::vec<3, Real> offset = hit - start;
  const Real axis2 = dot_product(axis, axis);
  const Real place = axis2 > Real(0) ? saturate(dot_product(offset, axis) / axis2) : Real(0);
  const Real radius = start_radius + place * (end_radius - start_radius);
  return fibre_hit_of(offset - place * axis, direction, axis, radius);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
