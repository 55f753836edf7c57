// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/version.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// The disc that stands for a pixel: a fibre covers the share of it that disc_strip_share() gives. On average over its
/// places the sum over pixels is the fibre's area in pixels, with each of them; how far the sum swings for an upright
/// straight fibre 1/500 of a pixel wide, and the RMS of a pixel's share from the area of the fibre in the square pixel,
/// over all angles and places within a pixel of its axis, both over the width, are:
enum class pixel_footprint {
  inscribed,   ///< touches the pixel's sides, radius 1/2: 0.05 to 1.27, RMS 0.15; fibres between two columns vanish
  equal_area,  ///< as large as the pixel, radius 1/sqrt(pi): 0.72 to 1.13, RMS 0.09; 1.13 times as many fragments
  yu           ///< two pixels wide, radius 1, as [Yu12 Eq. 6] is printed: 0.65 to 1.10, RMS 0.37; twice as many
};

/// The disc's radius in sides of the pixel.
template <std::floating_point Real>
[[nodiscard]] constexpr Real disc_radius(pixel_footprint footprint) noexcept {
  if (footprint == pixel_footprint::inscribed) {
    return Real(0.5);
  }
  return footprint == pixel_footprint::equal_area ? Real(0.56418958354775629) : Real(1);
}

/// The cone (perspective) or cylinder (orthographic) of rays that one pixel gathers: its disc's radius grows linearly
/// with view depth. [Yu12 Eq. 6] has it grow with the distance from the eye instead, which makes discs larger than
/// their pixels toward the sides of the picture.
template <std::floating_point Real>
struct ray_cone {
  Real base;   ///< the disc's radius at depth 0, length units, [0, inf)
  Real slope;  ///< growth of the radius per unit of view depth, [0, inf); 0 exactly when orthographic
};

/// The cone of a perspective camera's pixel. `tan_half_fov`: tangent of half the vertical field of view, (0, inf).
/// `height`: pixels from bottom to top, [1, inf).
template <std::floating_point Real>
[[nodiscard]] constexpr ray_cone<Real> perspective_cone(
    Real tan_half_fov, int height, pixel_footprint footprint = pixel_footprint::equal_area) noexcept {
  return ray_cone<Real>{Real(0), Real(2) * disc_radius<Real>(footprint) * tan_half_fov / Real(height)};
}

/// The cylinder of an orthographic map's texel: `extent` length units across `texels` texels, [1, inf).
template <std::floating_point Real>
[[nodiscard]] constexpr ray_cone<Real> orthographic_cone(
    Real extent, int texels, pixel_footprint footprint = pixel_footprint::equal_area) noexcept {
  return ray_cone<Real>{disc_radius<Real>(footprint) * extent / Real(texels), Real(0)};
}

/// The disc's radius at a view depth (along the axis of view, not along the ray). Depths behind the eye count as 0.
template <std::floating_point Real>
[[nodiscard]] constexpr Real radius_at(ray_cone<Real> cone, Real depth) noexcept {
  return cone.base + cone.slope * (depth > Real(0) ? depth : Real(0));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
