// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/coverage/curve_basis.hpp>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <concepts>
#include <cstdint>
#include <limits>

namespace pelage::inline PELAGE_ABI {

/// A Bézier curve as lines: point_of_piece() from 0 to pieces_within(). Curves that share an end share its bits,
/// however many pieces each has: no cracks.
///
/// A piece and its line are at most an error E apart at equal parameters, so that each point of either has one of the
/// other within E, and their radii differ by at most the error of radii. A line of length C stands for a piece as
/// long as C to greatest_piece_length(C, E). Bounds hold up to rounding, 16 ε times the largest |x| + |y| + |z| of the
/// four points (or times the largest |w|), and to 4 ε of themselves; ε is 2⁻²³ in float. They hold for cusps and loops,
/// too. For differences of points and errors in [2⁻⁵⁰, 2⁵⁰] in float, in [2⁻⁴⁵⁰, 2⁴⁵⁰] in double; the square of a
/// smaller difference may be 0.

/// The most pieces that a curve is cut into.
[[nodiscard]] constexpr std::uint32_t most_curve_pieces() noexcept {
  return 1024u;
}

/// The fewest pieces of equal parameters for which piece_error() is at most `error`, and radius_piece_error()
/// `radius_error`, [1, most_curve_pieces()]. Wang's bound: the error of n pieces is 3/(4 n²) of the largest second
/// difference of the points. The same number on every device, since it needs neither division nor root.
///
/// Errors are in the units of x, y, z and of w, [0, inf]; with colours and opacities in the place of both, in theirs.
/// An error of 0, negative or NaN gives the most for what is not straight, and so does one that needs more:
/// piece_error() tells what is kept then. Infinite ones ask for nothing. Places that are straight but for rounding,
/// with even speed, are one piece, and so are places with NaN, infinities or second differences beyond 2⁶² in float;
/// radii likewise, each of the two for itself. O(1), ten steps.
template <std::floating_point Real>
[[nodiscard]] std::uint32_t pieces_within(const bezier_segment<Real>& curve, Real error, Real radius_error) noexcept;

/// How far from its line a piece may be, [0, inf). `pieces`: [1, inf).
template <std::floating_point Real>
[[nodiscard]] Real piece_error(const bezier_segment<Real>& curve, std::uint32_t pieces) noexcept;

/// How far a piece's fourth number may be from linear.
template <std::floating_point Real>
[[nodiscard]] Real radius_piece_error(const bezier_segment<Real>& curve, std::uint32_t pieces) noexcept;

/// The greatest length of a piece whose line is so long, with its piece_error(): √(line² + 16/3 error²), at most 2.31
/// errors more than the line, and at most 8/3 error²/line more: over an interval h of the parameter the second
/// derivative is at most 8 error/h² and the first one's variance so at most 64/12 (error/h)², which is all that its
/// mean square has above the square of its mean.
template <std::floating_point Real>
[[nodiscard]] Real greatest_piece_length(Real line, Real error) noexcept {
  return square_root(line * line + Real(5.3333333333333333) * error * error);
}

/// The end of piece i - 1 and the start of piece i: the curve at i/pieces, within 8 ε of the largest component's
/// magnitude. Exactly the curve's ends at 0 and from `pieces` on. A curve reversed gives the same bits at pieces - i.
template <std::floating_point Real>
[[nodiscard]] glm::vec<4, Real> point_of_piece(const bezier_segment<Real>& curve, std::uint32_t i,
                                               std::uint32_t pieces) noexcept;

/// The error in length units that keeps an error on a perspective screen, for a curve in view space: eye at the origin,
/// looking down -z. `screen_error`: at depth 1, [0, inf): p pixels are 2 p tan_half_fov / height. Of the curve beyond
/// the plane z = -near_plane, near_plane in (0, inf), no point is farther from its line's on the screen. It is
/// screen_error times the smallest depth d of the four points, less where they are off the axis:
/// d²/√(d² + max(x² + y²)). With an orthographic view the error is the same everywhere, and this not needed.
template <std::floating_point Real>
[[nodiscard]] Real error_on_screen(const bezier_segment<Real>& curve, Real screen_error, Real near_plane) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// The squares of the largest second differences, of x, y, z and of w, each 0 where it is rounding, NaN or infinite.
template <std::floating_point Real>
[[nodiscard]] glm::vec<2, Real> second_differences(const bezier_segment<Real>& curve) noexcept {
  glm::vec<2, Real> size(Real(0), Real(0));
  for (const glm::vec<4, Real>& p : curve.point) {
    size.x = greatest(size.x, absolute(p.x) + absolute(p.y) + absolute(p.z));
    size.y = greatest(size.y, absolute(p.w));
  }
  const glm::vec<4, Real> first = (curve.point[0] - curve.point[1]) + (curve.point[2] - curve.point[1]);
  const glm::vec<4, Real> second = (curve.point[1] - curve.point[2]) + (curve.point[3] - curve.point[2]);
  const Real first2 = first.x * first.x + first.y * first.y + first.z * first.z;
  const Real second2 = second.x * second.x + second.y * second.y + second.z * second.z;
  const Real most = greatest(first2, second2);
  const Real radius_most = greatest(first.w * first.w, second.w * second.w);
  const Real rounding = Real(8) * std::numeric_limits<Real>::epsilon();
  const Real least_seen = (rounding * size.x) * (rounding * size.x);
  const Real least_radius = (rounding * size.y) * (rounding * size.y);
  const Real infinite = std::numeric_limits<Real>::infinity();
  const bool finite = first2 + second2 < infinite;
  const bool finite_radius = first.w * first.w + second.w * second.w < infinite;
  return glm::vec<2, Real>(finite && most > least_seen ? most : Real(0),
                           finite_radius && radius_most > least_radius ? radius_most : Real(0));
}

/// Whether so many pieces leave more than an error of a second difference whose square is given.
template <std::floating_point Real>
[[nodiscard]] bool leave_more(std::uint32_t pieces, Real difference2, Real error) noexcept {
  const Real reached = Real(pieces) * Real(pieces) * error;
  return reached * reached < Real(0.5625) * difference2;
}

}  // namespace detail

template <std::floating_point Real>
std::uint32_t pieces_within(const bezier_segment<Real>& curve, Real error, Real radius_error) noexcept {
  const glm::vec<2, Real> difference2 = detail::second_differences(curve);
  const Real allowed = error > Real(0) ? error : Real(0);
  const Real allowed_radius = radius_error > Real(0) ? radius_error : Real(0);
  std::uint32_t pieces = 1u;
  for (std::uint32_t added = most_curve_pieces() / 2u; added > 0u; added /= 2u) {
    const std::uint32_t tried = pieces + added - 1u;
    if (detail::leave_more(tried, difference2.x, allowed) || detail::leave_more(tried, difference2.y, allowed_radius)) {
      pieces += added;
    }
  }
  return pieces;
}

template <std::floating_point Real>
Real piece_error(const bezier_segment<Real>& curve, std::uint32_t pieces) noexcept {
  return Real(0.75) * square_root(detail::second_differences(curve).x) / (Real(pieces) * Real(pieces));
}

template <std::floating_point Real>
Real radius_piece_error(const bezier_segment<Real>& curve, std::uint32_t pieces) noexcept {
  return Real(0.75) * square_root(detail::second_differences(curve).y) / (Real(pieces) * Real(pieces));
}

template <std::floating_point Real>
glm::vec<4, Real> point_of_piece(const bezier_segment<Real>& curve, std::uint32_t i, std::uint32_t pieces) noexcept {
  if (i == 0u) {
    return curve.point[0];
  }
  if (i >= pieces) {
    return curve.point[3];
  }
  const Real t = Real(i) / Real(pieces);
  const Real s = Real(pieces - i) / Real(pieces);
  const glm::vec<4, Real> ends = curve.point[0] * (s * s * s) + curve.point[3] * (t * t * t);
  const glm::vec<4, Real> middle = curve.point[1] * (s * s * t) + curve.point[2] * (t * t * s);
  return ends + middle * Real(3);
}

template <std::floating_point Real>
Real error_on_screen(const bezier_segment<Real>& curve, Real screen_error, Real near_plane) noexcept {
  Real depth = Real(0) - curve.point[0].z;
  Real aside2 = Real(0);
  for (const glm::vec<4, Real>& p : curve.point) {
    depth = least(depth, Real(0) - p.z);
    aside2 = greatest(aside2, p.x * p.x + p.y * p.y);
  }
  depth = greatest(depth, near_plane);
  return screen_error * depth * (depth / square_root(depth * depth + aside2));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
