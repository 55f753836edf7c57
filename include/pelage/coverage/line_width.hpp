// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <glm/vec2.hpp>

#include <cmath>
#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// How much longer a line is than the row of pixels that draws it: √(x² + y²) / max(|x|, |y|), [1, √2].
/// A line of one pixel per row or column leaves 1 pixel for every √2 of a diagonal.
/// `extent`: the segment from end to end, pixels, finite. A segment of length 0, or NaN: 1.
template <std::floating_point Real>
[[nodiscard]] Real diagonal_ratio(const glm::vec<2, Real>& extent) noexcept;

/// The coverage to give every pixel of a one-pixel line so that it weighs as much as the fibre, [0, 1]: the fibre's
/// width w in pixels times the diagonal ratio. [Svoboda §1.2.3, Eq. 1.1, which has the same Rat = (1 + √2)/2 - w/4 for
/// all angles: 21 % too much at 0° and 15 % too little at 45° for a thin line; ours is right at each] The cheap
/// alternative to disc_strip_share: no position inside the pixel, so right on average along a line up to a width of 0.7
/// pixels, wrong in each pixel. Over all angles and offsets its RMS error against disc_strip_share in the pixels that
/// it draws is 0.012, 0.051, 0.142 and 0.229 for fibres of 0.05, 0.2, 0.5 and 1 pixel.
///
/// `fibre_radius` and `pixel_radius` (half a pixel) in one length unit at the segment's depth. Fibres wider than the
/// line saturate at 1. A pixel of radius 0, or a NaN radius: 0.
template <std::floating_point Real>
[[nodiscard]] Real line_width_share(const glm::vec<2, Real>& extent, Real fibre_radius, Real pixel_radius) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
Real diagonal_ratio(const glm::vec<2, Real>& extent) noexcept {
  const Real x = std::abs(extent.x);
  const Real y = std::abs(extent.y);
  const Real longest = x > y ? x : y;
  const Real shortest = x > y ? y : x;
  if (!(longest > Real(0))) {
    return Real(1);
  }
  const Real slope = shortest / longest;
  return slope > Real(0) ? std::sqrt(Real(1) + slope * slope) : Real(1);
}

template <std::floating_point Real>
Real line_width_share(const glm::vec<2, Real>& extent, Real fibre_radius, Real pixel_radius) noexcept {
  if (!(fibre_radius > Real(0)) || !(pixel_radius > Real(0))) {
    return Real(0);
  }
  return saturate(fibre_radius / pixel_radius * diagonal_ratio(extent));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
