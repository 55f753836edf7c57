// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lane_math.hpp>
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>

#include <limits>

namespace pelage {

/// The kernels of closest_points.hpp and disc_strip.hpp for W pixels at once, on the CPU: each lane has the bits that
/// the scalar kernel in float gives. Branches become choices; a part of the formula that no lane needs is skipped.

/// W points or directions.
template <int W>
struct lane_points {
  lanes<W> x, y, z;
};

/// Closest pairs of W rays and W segments; fields as closest_pair has them.
template <int W>
struct closest_lanes {
  lanes<W> along_ray, along_segment, distance;
};

/// closest_points() of each lane.
template <int W>
[[nodiscard, gnu::always_inline]] inline closest_lanes<W> closest_points(const lane_points<W>& origin,
                                                                         const lane_points<W>& direction,
                                                                         const lane_points<W>& start,
                                                                         const lane_points<W>& end) noexcept;

/// disc_strip_share() of each lane.
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> disc_strip_share(lanes<W> offset, lanes<W> fibre_radius,
                                                                   lanes<W> disc_radius) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> dot(const lane_points<W>& a, const lane_points<W>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <int W>
[[nodiscard, gnu::always_inline]] inline lane_points<W> cross(const lane_points<W>& a,
                                                              const lane_points<W>& b) noexcept {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}

template <int W>
[[nodiscard, gnu::always_inline]] inline lane_points<W> minus(const lane_points<W>& a,
                                                              const lane_points<W>& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <int W>
[[nodiscard, gnu::always_inline]] inline lane_points<W> scaled(lanes<W> s, const lane_points<W>& a) noexcept {
  return {s * a.x, s * a.y, s * a.z};
}

template <int W>
[[nodiscard, gnu::always_inline]] inline lane_points<W> plus(const lane_points<W>& a,
                                                             const lane_points<W>& b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> cap_share(lanes<W> h) noexcept {
  const lanes<W> one(1.0f);
  const lanes<W> two(2.0f);
  const lanes<W> whole = select(h > lanes<W>(0.0f), select(h < two, h, two), lanes<W>(0.0f));
  const lanes<W> small = select(whole > one, two - whole, whole);
  lanes<W> p(-0.000177318844f);
  p = p * small + lanes<W>(0.000137821731f);
  p = p * small - lanes<W>(0.000604818362f);
  p = p * small - lanes<W>(0.00148269381f);
  p = p * small - lanes<W>(0.00805321381f);
  p = p * small - lanes<W>(0.090030634f);
  p = p * small + lanes<W>(0.600210866f);
  const lanes<W> share = small * square_root(small) * p;
  return select(whole > one, one - share, share);
}

}  // namespace detail

template <int W>
closest_lanes<W> closest_points(const lane_points<W>& origin, const lane_points<W>& direction,
                                const lane_points<W>& start, const lane_points<W>& end) noexcept {
  const lanes<W> zero(0.0f);
  const lane_points<W> axis = detail::minus(end, start);
  const lane_points<W> offset = detail::minus(start, origin);
  const lane_points<W> offset_seen = detail::cross(offset, direction);
  const lane_points<W> axis_seen = detail::cross(axis, direction);
  const lanes<W> seen2 = detail::dot(axis_seen, axis_seen);
  const lanes<W> end_on = select(detail::dot(axis, direction) < zero, lanes<W>(1.0f), zero);
  lanes<W> s = select(seen2 > zero, saturate((zero - detail::dot(offset_seen, axis_seen)) / seen2), end_on);
  lanes<W> t =
      detail::dot(detail::plus(offset, detail::scaled(s, axis)), direction) / detail::dot(direction, direction);
  const lane_mask<W> behind = t < zero;
  if (bits(behind) != 0u) {
    const lanes<W> axis2 = detail::dot(axis, axis);
    const lanes<W> nearest = saturate((zero - detail::dot(offset, axis)) / axis2);
    s = select(behind, select(axis2 > zero, nearest, zero), s);
    t = select(behind, zero, t);
  }
  const lane_points<W> gap = detail::minus(detail::plus(offset, detail::scaled(s, axis)), detail::scaled(t, direction));
  return {t, s, square_root(detail::dot(gap, gap))};
}

template <int W>
lanes<W> disc_strip_share(lanes<W> offset, lanes<W> fibre_radius, lanes<W> disc_radius) noexcept {
  const lanes<W> zero(0.0f);
  const lanes<W> two(2.0f);
  const lanes<W> d = select(offset < zero, zero - offset, offset);
  const lane_mask<W> is_wide = fibre_radius > disc_radius;
  const lanes<W> reach = (select(is_wide, fibre_radius, disc_radius) - d) + select(is_wide, disc_radius, fibre_radius);
  const lanes<W> left_over = (disc_radius - d) - fibre_radius;
  const lanes<W> rho = fibre_radius / disc_radius;
  const lanes<W> edge = (disc_radius - d) / disc_radius;
  const lane_mask<W> is_thin = edge > lanes<W>(4.0f) * rho;

  lanes<W> share = zero;
  if (bits(is_thin) != all_bits<W>()) {
    const lanes<W> near = detail::cap_share(reach / disc_radius);
    share = select(left_over > zero, near - detail::cap_share(left_over / disc_radius), near);
  }
  if (bits(is_thin) != 0u) {
    const lanes<W> middle = square_root(edge * (two - edge));
    const lanes<W> lower = edge - lanes<W>(0.7745966692414834f) * rho;
    const lanes<W> upper = edge + lanes<W>(0.7745966692414834f) * rho;
    const lanes<W> sides = square_root(lower * (two - lower)) + square_root(upper * (two - upper));
    const lanes<W> strip = rho * (lanes<W>(8.0f) * middle + lanes<W>(5.0f) * sides) * lanes<W>(0.07073553026306459f);
    share = select(left_over > zero, select(is_thin, strip, share), share);
  }
  share = select(reach < two * disc_radius, share, lanes<W>(1.0f));
  const lanes<W> greatest(std::numeric_limits<float>::max());
  share = select(reach > zero, share, zero);
  share = select(fibre_radius > zero, share, zero);
  return select(disc_radius < zero, zero, select(disc_radius > greatest, zero, share));
}

}  // namespace pelage
