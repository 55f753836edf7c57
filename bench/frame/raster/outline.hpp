// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>

#include "frame/scene/view.hpp"

namespace pelage::frame {

/// A strand's point as a view sees it, together what a fragment needs. Real: float, or a pack of floats for as many
/// points.
template <class Real>
struct alignas(sizeof(Real) == sizeof(float) ? 32 : alignof(Real)) projected_point {
  Real x, y, z;  ///< view space
  Real radius;
  Real pixel_x, pixel_y;  ///< pixel coordinates
  Real joint_x, joint_y;  ///< the strand's direction on the screen, any length
};

/// The pixels that a segment may touch: those of a box, and in each of its rows those near a slanted line. A pixel's
/// centre lies at most `half` beside the line's crossing with its row, (x, y) + n (slope, 1).
template <class Real>
struct outline {
  Real x0, y0, x1, y1;  ///< whole numbers; empty where x0 >= x1 or y0 >= y1
  Real x, y, slope, half;
  Real fails;  ///< 0, or more: the segment reaches past the near plane or far beyond the view, and the rest is void
};

/// Pixel coordinates up to which rounding stays below `outline_rounding` pixels; a view's sides are half of it.
inline constexpr float farthest_pixel = 32768.0F;
inline constexpr float outline_rounding = 0.1F;

/// What `half` is where a row's pixels are limited by the box alone.
inline constexpr float any_distance = 4.0F * farthest_pixel;

/// The first pixel of [low, high] whose centre does not lie before x, which may be any number; `low` for NaN.
template <class Real>
[[nodiscard]] Real first_centre_from(Real x, Real low, Real high);

/// `stretch`: from gaps beside a ray to distances on the screen, screen_stretch().
template <class Real>
[[nodiscard]] outline<Real> outline_of(const projected_point<Real>& start, const projected_point<Real>& end,
                                       const view& from, float stretch);

/// The greatest factor from the gap between a ray and a point of a fibre, in pixels at the point's depth, to their
/// distance on the screen. The gap stands at right angles to the ray, not to the view; and a pixel's disc is measured
/// at the ray's depth, which is greater than the point's by the gap at most.
[[nodiscard]] float screen_stretch(const view& from);

// ---------------------------------------------------------------------------------------------------------

template <class Real>
[[gnu::always_inline]] inline Real first_centre_from(Real x, Real low, Real high) {
  const Real before = x - Real(0.5F);
  const Real held = select(before > low, select(before < high, before, high), low);
  const Real whole = whole_part(held);
  return whole + select(whole < held, Real(1.0F), Real(0.0F));
}

template <class Real>
[[gnu::always_inline]] inline outline<Real> outline_of(const projected_point<Real>& start,
                                                       const projected_point<Real>& end, const view& from,
                                                       float stretch) {
  const Real zero(0.0F);
  const Real one(1.0F);
  const Real farthest(farthest_pixel);
  const Real nearest = zero - greatest(start.z, end.z);
  const Real pixels = greatest(start.radius, end.radius) * Real(from.scale) / (from.perspective ? nearest : one);
  const Real reach = Real(stretch) * (pixels + Real(from.disc())) + Real(outline_rounding);
  outline<Real> found;
  found.fails = select(nearest < Real(from.near_plane), one, zero) + select(reach < farthest, zero, one);
  for (const Real coordinate : {start.pixel_x, start.pixel_y, end.pixel_x, end.pixel_y})
    found.fails = found.fails + select(absolute(coordinate) < farthest, zero, one);

  const Real width(static_cast<float>(from.width));
  const Real height(static_cast<float>(from.height));
  found.x0 = first_centre_from(least(start.pixel_x, end.pixel_x) - reach, zero, width);
  found.y0 = first_centre_from(least(start.pixel_y, end.pixel_y) - reach, zero, height);
  found.x1 = first_centre_from(greatest(start.pixel_x, end.pixel_x) + reach, zero, width);
  found.y1 = first_centre_from(greatest(start.pixel_y, end.pixel_y) + reach, zero, height);

  const Real span_x = end.pixel_x - start.pixel_x;
  const Real span_y = end.pixel_y - start.pixel_y;
  const auto is_steep = absolute(span_x) < Real(64.0F) * absolute(span_y);
  found.x = start.pixel_x;
  found.y = start.pixel_y;
  found.slope = select(is_steep, span_x / select(is_steep, span_y, one), zero);
  found.half = select(is_steep, reach * square_root(one + found.slope * found.slope), Real(any_distance));
  return found;
}

}  // namespace pelage::frame
