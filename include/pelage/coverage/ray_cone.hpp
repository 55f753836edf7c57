// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// The cone (perspective) or cylinder (orthographic) of rays that one pixel gathers: its disc's radius grows
/// linearly with view depth. Perspective: Yu12 Eq. 6.
template <std::floating_point Real>
struct ray_cone {
  Real base;   ///< the disc's radius at depth 0, length units, [0, inf)
  Real slope;  ///< growth of the radius per unit of view depth, [0, inf); 0 exactly when orthographic
};

/// The cone of a perspective camera's pixel: the disc touches the pixel's sides. `tan_half_fov`: tangent of half
/// the vertical field of view, (0, inf). `height`: pixels from bottom to top, [1, inf).
template <std::floating_point Real>
[[nodiscard]] constexpr ray_cone<Real> perspective_cone(Real tan_half_fov, int height) noexcept {
  return ray_cone<Real>{Real(0), tan_half_fov / Real(height)};
}

/// The cylinder of an orthographic map's texel: `extent` length units across `texels` texels, [1, inf).
template <std::floating_point Real>
[[nodiscard]] constexpr ray_cone<Real> orthographic_cone(Real extent, int texels) noexcept {
  return ray_cone<Real>{Real(0.5) * extent / Real(texels), Real(0)};
}

/// The disc's radius at a view depth (along the axis of view, not along the ray). Depths behind the eye count as 0.
template <std::floating_point Real>
[[nodiscard]] constexpr Real radius_at(ray_cone<Real> cone, Real depth) noexcept {
  return cone.base + cone.slope * (depth > Real(0) ? depth : Real(0));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
