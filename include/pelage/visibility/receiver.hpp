// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/real_number.hpp>
#include <pelage/core/vector_math.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pelage::inline PELAGE_ABI {

/// How what receives a shadow slants in a shadow map: a place between texels' centres is compared with what lies in
/// those texels, where the receiver itself has another depth. Taken from there it neither shadows itself nor needs a
/// bias as wide as a texel, by which light leaks in. [the receiver plane depth bias of Isidoro 2006, for fibres too]
///
/// In the map's view space, which looks along -z. `ray`: the way of the light through the place, z = -1: (0, 0, -1) in
/// an orthographic map, in a perspective one the place over its depth. The slope is the growth of view depth per unit
/// of length to the right (x) and up (y), measured at the place's depth: times the offset of a texel's centre it gives
/// the receiver's depth there, in a perspective map to first order in the offset.
///
/// `steepest`: the slope's greatest length, (0, 2¹⁶]. A slope that would be longer is `steepest`² over it, in the same
/// direction: 0 end on, where a texel's offset says nothing. The renderer takes 64, and looks a fibre up its own width
/// before that depth. Directions may have any length in [2⁻⁸, 2⁸]; 0 gives 0. NaN gives NaN.

/// Of a fibre along `tangent`, of either sign: the slope of closest_points' `along_ray`, so of its fragments.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline glm::vec<2, Real> line_depth_slope(const glm::vec<3, Real>& ray,
                                                                            const glm::vec<3, Real>& tangent,
                                                                            Real steepest) noexcept;

/// Of a surface with `normal`, of either sign.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline glm::vec<2, Real> plane_depth_slope(const glm::vec<3, Real>& ray,
                                                                             const glm::vec<3, Real>& normal,
                                                                             Real steepest) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// (x, y) / run, or what stands for it above `steepest`.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline glm::vec<2, Real> limited_slope(Real x, Real y, Real run,
                                                                         Real steepest) noexcept {
  const Real run2 = run * run;
  const Real least2 = (x * x + y * y) / (steepest * steepest);
  const Real divisor = select(run2 < least2, least2, run2);
  const Real share = run / select(divisor > Real(0), divisor, Real(1));
  return glm::vec<2, Real>(x * share, y * share);
}

}  // namespace detail

template <real_number Real>
glm::vec<2, Real> line_depth_slope(const glm::vec<3, Real>& ray, const glm::vec<3, Real>& tangent,
                                   Real steepest) noexcept {
  const glm::vec<3, Real> across = cross_product(tangent, ray);
  const glm::vec<3, Real> rise = cross_product(tangent, across);
  return detail::limited_slope(rise.x, rise.y, dot_product(across, across), steepest);
}

template <real_number Real>
glm::vec<2, Real> plane_depth_slope(const glm::vec<3, Real>& ray, const glm::vec<3, Real>& normal,
                                    Real steepest) noexcept {
  return detail::limited_slope(normal.x, normal.y, Real(0) - dot_product(normal, ray), steepest);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
