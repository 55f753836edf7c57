// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/flatten_curve.hpp>

#include "coverage/exact_curve.hpp"
#include "property.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

long double length_of(const exact_value& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

template <class Real>
std::vector<glm::vec<4, Real>> points_of(const bezier_segment<Real>& curve, std::uint32_t pieces) {
  std::vector<glm::vec<4, Real>> points;
  for (std::uint32_t i = 0; i <= pieces; ++i)
    points.push_back(point_of_piece(curve, i, pieces));
  return points;
}

/// What the lines of a curve are off by, at worst: places, radii, and lengths over what the header allows.
struct deviation {
  long double place = 0, radius = 0, excess = 0;
};

template <class Real, class Exact>
deviation deviation_of(const std::vector<glm::vec<4, Real>>& points, Real error, Exact exact) {
  const std::size_t pieces = points.size() - 1;
  const int samples = pieces > 100 ? 4 : 16;
  deviation worst;
  for (std::size_t i = 0; i < pieces; ++i) {
    const exact_value start(points[i]);
    const exact_value end(points[i + 1]);
    long double length = 0;
    exact_value last = exact(static_cast<long double>(i) / static_cast<long double>(pieces));
    for (int k = 1; k <= samples; ++k) {
      const long double along = static_cast<long double>(k) / samples;
      const exact_value now = exact((static_cast<long double>(i) + along) / static_cast<long double>(pieces));
      const exact_value difference = start + (end - start) * along - now;
      worst.place = std::max(worst.place, length_of(difference));
      worst.radius = std::max(worst.radius, std::abs(difference.w));
      length += length_of(now - last);
      last = now;
    }
    const long double most = greatest_piece_length(length_of(end - start), static_cast<long double>(error));
    worst.excess = std::max({worst.excess, length - most, length_of(end - start) - length});
  }
  return worst;
}

template <class Real>
void check_deviation(curve_basis basis, curve_wrap wrap) {
  const auto vertices = drawn_vertices<Real>(basis, wrap);
  const auto expected = exact_segments(basis, wrap, exact_values(vertices));
  const auto found = segments_of(basis, wrap, vertices);
  const Real error = std::exp2(static_cast<Real>(*rc::gen::inRange(-18, 3)));
  const Real radius_error = std::exp2(static_cast<Real>(*rc::gen::inRange(-18, 3)));
  const long double epsilon = std::numeric_limits<Real>::epsilon();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::uint32_t pieces = pieces_within(found[i], error, radius_error);
    const Real bound = piece_error(found[i], pieces);
    const Real radius_bound = radius_piece_error(found[i], pieces);
    if (pieces < most_curve_pieces()) {
      RC_ASSERT(bound <= error * (1 + 4 * std::numeric_limits<Real>::epsilon()));
      RC_ASSERT(radius_bound <= radius_error * (1 + 4 * std::numeric_limits<Real>::epsilon()));
    }
    const auto points = points_of(found[i], pieces);
    std::array<exact_value, 4> bezier;
    std::copy(found[i].point.begin(), found[i].point.end(), bezier.begin());
    const deviation here =
        deviation_of(points, bound, [&](long double t) { return exact_point(curve_basis::bezier, bezier, t); });
    RC_ASSERT(here.place <=
              static_cast<long double>(bound) * (1 + 4 * epsilon) + 16 * epsilon * largest_size(found[i]));
    RC_ASSERT(here.radius <=
              static_cast<long double>(radius_bound) * (1 + 4 * epsilon) + 16 * epsilon * largest_radius(found[i]));
    const deviation worst =
        deviation_of(points, bound, [&](long double t) { return exact_point(basis, expected[i], t); });
    // The way from the vertices to a Bézier curve rounds by as much again: curve_basis.cpp.
    long double size = 0, width = 0;
    for (const exact_value& v : expected[i]) {
      size = std::max(size, size_of(v));
      width = std::max(width, std::abs(v.w));
    }
    RC_ASSERT(worst.place <= static_cast<long double>(bound) * (1 + 4 * epsilon) + 32 * epsilon * size);
    RC_ASSERT(worst.radius <= static_cast<long double>(radius_bound) * (1 + 4 * epsilon) + 32 * epsilon * width);
    RC_ASSERT(worst.excess <= 64 * epsilon * size + 8 * epsilon * static_cast<long double>(bound));
  }
}

TEST_CASE("lines are as near to the exact curve as asked, in place, radius and length") {
  holds("in float, for every basis and wrap", [] { for_each_kind(check_deviation<float>); });
  holds("in double, for every basis and wrap", [] { for_each_kind(check_deviation<double>); });
}

TEST_CASE("cusps and loops are within the bounds, and a cusp of one piece needs most of them") {
  const bezier_segment<double> cusp{
      {glm::dvec4(0), glm::dvec4(1, 1, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(1, 0, 0, 0)}};
  const bezier_segment<double> turned{{glm::dvec4(0), glm::dvec4(1, 0, 0, 0), glm::dvec4(1, 0, 0, 0), glm::dvec4(0)}};
  const bezier_segment<double> loop{
      {glm::dvec4(0), glm::dvec4(3, 2, 0, 0), glm::dvec4(-2, 2, 0, 0), glm::dvec4(1, 0, 0, 0)}};
  for (const bezier_segment<double>& curve : {cusp, turned, loop}) {
    std::array<exact_value, 4> points;
    std::copy(curve.point.begin(), curve.point.end(), points.begin());
    for (std::uint32_t pieces = 1; pieces < 40; ++pieces) {
      const double bound = piece_error(curve, pieces);
      const deviation worst = deviation_of(points_of(curve, pieces), bound,
                                           [&](long double t) { return exact_point(curve_basis::bezier, points, t); });
      CHECK(worst.place <= bound * (1 + 1e-15L) + 1e-15L);
      CHECK(worst.excess <= 1e-15L);
    }
  }
  CHECK(greatest_piece_length(0.0, piece_error(turned, 1u)) < 1.2 * 1.5);  // there and back: 2 · 0.75
}

/// Of the unit circle, but for what a cubic may differ from it.
bezier_segment<double> arc_of(double angle) {
  const double handle = 4.0 / 3.0 * std::tan(angle / 4.0);
  const glm::dvec4 start(1, 0, 0, 0), end(std::cos(angle), std::sin(angle), 0, 0);
  return {{start, start + handle * glm::dvec4(0, 1, 0, 0), end + handle * glm::dvec4(end.y, -end.x, 0, 0), end}};
}

TEST_CASE("the whole length falls short by no more than the pieces' bounds together") {
  holds("for a tenth of a circle and more", [] {
    const double angle = 1e-3 * *rc::gen::inRange(300, 1571);
    const bezier_segment<double> arc = arc_of(angle);
    const double error = std::exp2(-*rc::gen::inRange(4, 16));
    const std::uint32_t pieces = pieces_within(arc, error, 1.0);
    const auto points = points_of(arc, pieces);
    double shortest = 0, longest = 0;
    for (std::size_t i = 0; i < pieces; ++i) {
      const double line = glm::length(glm::dvec3(points[i + 1] - points[i]));
      shortest += line;
      longest += greatest_piece_length(line, error);
    }
    RC_ASSERT(shortest <= angle * (1.0 + 3e-4));  // what the cubic's own arc may differ from the circle's
    RC_ASSERT(angle <= longest * (1.0 + 3e-4));
  });
}

TEST_CASE("no more pieces than half as many again as an arc needs, and one") {
  holds("for arcs of a circle", [] {
    const double angle = 1e-3 * *rc::gen::inRange(300, 1571);
    const bezier_segment<double> arc = arc_of(angle);
    const double error = std::exp2(-*rc::gen::inRange(4, 20));
    const double pieces = pieces_within(arc, error, 1.0);
    // The sagitta of each of n equal parts of the circle is 1 - cos(angle / 2n).
    const double needed = std::ceil(angle / (2.0 * std::acos(1.0 - error)));
    RC_ASSERT(pieces <= 1.5 * needed + 1.0);
    RC_ASSERT(pieces >= needed * 0.95);
  });
}

TEST_CASE("the count is the least that keeps both errors") {
  holds("for every basis", [] {
    for_each_kind([](curve_basis basis, curve_wrap wrap) {
      const double error = std::exp2(-*rc::gen::inRange(0, 20));
      const double radius_error = std::exp2(-*rc::gen::inRange(0, 20));
      for (const auto& curve : segments_of(basis, wrap, drawn_vertices<double>(basis, wrap))) {
        const std::uint32_t pieces = pieces_within(curve, error, radius_error);
        RC_ASSERT(pieces >= 1u);
        RC_ASSERT(pieces <= most_curve_pieces());
        if (basis == curve_basis::linear) RC_ASSERT(pieces == 1u);
        if (pieces > 1u) {
          const bool place = piece_error(curve, pieces - 1u) > error * (1.0 - 1e-14);
          RC_ASSERT(place || radius_piece_error(curve, pieces - 1u) > radius_error * (1.0 - 1e-14));
        }
      }
    });
  });
}

TEST_CASE("a linear segment is one piece in float, too, whatever the error") {
  holds("with widths that vary or not", [] {
    const auto vertices = drawn_vertices<float>(curve_basis::linear, curve_wrap::periodic);
    for (const auto& curve : segments_of(curve_basis::linear, curve_wrap::periodic, vertices))
      RC_ASSERT(pieces_within(curve, 0.0f, 0.0f) == 1u);
    const auto curved = drawn_vertices<float>(curve_basis::b_spline, curve_wrap::periodic);
    for (const auto& curve : segments_of(curve_basis::b_spline, curve_wrap::periodic, curved)) {
      const auto varied = with_varying(curve, curved[0].w, curved[1].w);
      RC_ASSERT(pieces_within(varied, 1e-2f, 0.0f) == pieces_within(varied, 1e-2f, inf));
    }
  });
}

TEST_CASE("no cracks: pieces meet, and neighbours and periodic curves share the bits of their ends") {
  holds("for every basis and wrap", [] {
    for_each_kind([](curve_basis basis, curve_wrap wrap) {
      const float error = std::exp2(static_cast<float>(-*rc::gen::inRange(0, 20)));
      const auto curves = segments_of(basis, wrap, drawn_vertices<float>(basis, wrap));
      std::vector<glm::vec4> first, last;
      for (const auto& curve : curves) {
        const auto points = points_of(curve, pieces_within(curve, error, error));
        RC_ASSERT(points.front() == curve.point[0]);
        RC_ASSERT(points.back() == curve.point[3]);
        first.push_back(points.front());
        last.push_back(points.back());
      }
      for (std::size_t i = 0; i + 1 < curves.size(); ++i)
        RC_ASSERT(last[i] == first[i + 1]);
      if (wrap == curve_wrap::periodic) RC_ASSERT(last.back() == first.front());
    });
  });
}

TEST_CASE("a reversed curve has as many pieces and the same bits") {
  holds("for any Bézier curve", [] {
    const auto curve = segments_of(curve_basis::bezier, curve_wrap::nonperiodic,
                                   drawn_vertices<float>(curve_basis::bezier, curve_wrap::nonperiodic))
                           .front();
    auto back = curve;
    std::reverse(back.point.begin(), back.point.end());
    const float error = std::exp2(static_cast<float>(-*rc::gen::inRange(0, 20)));
    const std::uint32_t pieces = pieces_within(curve, error, error);
    RC_ASSERT(pieces_within(back, error, error) == pieces);
    for (std::uint32_t i = 0; i <= pieces; ++i)
      RC_ASSERT(point_of_piece(back, i, pieces) == point_of_piece(curve, pieces - i, pieces));
  });
}

TEST_CASE("an error kept at the smallest depth is kept on the screen") {
  holds("beyond the near plane", [] {
    bezier_segment<double> curve{};
    for (glm::dvec4& p : curve.point) {
      const auto coordinate = [](int low, int high) { return 1e-3 * *rc::gen::inRange(low, high); };
      p = glm::dvec4(coordinate(-4000, 4000), coordinate(-4000, 4000), coordinate(-4000, 500), 0.0);
    }
    const double screen = std::exp2(-*rc::gen::inRange(3, 10));
    const double near_plane = 0.25;
    const std::uint32_t pieces = pieces_within(curve, error_on_screen(curve, screen, near_plane), 1.0);
    RC_PRE(pieces < most_curve_pieces());
    std::array<exact_value, 4> exact;
    std::copy(curve.point.begin(), curve.point.end(), exact.begin());
    const auto points = points_of(curve, pieces);
    for (std::size_t i = 0; i < pieces; ++i) {
      for (int k = 0; k <= 8; ++k) {
        const long double along = k / 8.0L;
        const exact_value a = exact_value(points[i]) + exact_value(points[i + 1] - points[i]) * along;
        const exact_value b = exact_point(curve_basis::bezier, exact,
                                          (static_cast<long double>(i) + along) / static_cast<long double>(pieces));
        if (a.z > -near_plane || b.z > -near_plane) continue;
        RC_ASSERT(std::hypot(a.x / a.z - b.x / b.z, a.y / a.z - b.y / b.z) <= screen * (1.0L + 1e-12L));
      }
    }
  });
}

TEST_CASE("on the axis an error on the screen is that times the depth") {
  const bezier_segment<float> ahead{
      {glm::vec4(0, 0, -4, 0), glm::vec4(0, 0, -3, 0), glm::vec4(0, 0, -8, 0), glm::vec4(0, 0, -2, 0)}};
  CHECK(error_on_screen(ahead, 0.5f, 0.1f) == 1.0f);
  CHECK(error_on_screen(ahead, 0.5f, 3.0f) == 1.5f);
  CHECK(error_on_screen(ahead, 0.0f, 0.1f) == 0.0f);
}

constexpr bezier_segment<float> bow() {
  return {{glm::vec4(0, 0, 0, 1), glm::vec4(0, 1, 0, 1), glm::vec4(1, 1, 0, 1), glm::vec4(1, 0, 0, 1)}};
}

TEST_CASE("an error of 0, negative or NaN takes the most pieces, an infinite one a single piece") {
  for (const float none : {0.0f, -0.0f, -1.0f, -inf, nan, 1e-9f})
    CHECK(pieces_within(bow(), none, inf) == most_curve_pieces());
  CHECK(pieces_within(bow(), inf, 0.0f) == 1u);  // radii are all 1
  CHECK(piece_error(bow(), most_curve_pieces()) < 1.1e-6f);
  CHECK(piece_error(bow(), most_curve_pieces()) > 1e-9f);  // what is kept in place of what was asked
  const auto line = straight_segment(glm::vec4(0.1f), glm::vec4(0.7f, 0.3f, 0.9f, 0.2f));
  CHECK(pieces_within(line, 0.0f, 0.0f) == 1u);
  CHECK(pieces_within(straight_segment(glm::vec4(0.3f), glm::vec4(0.3f)), nan, nan) == 1u);
}

TEST_CASE("the range of coordinates and errors has no hole: counts do not change with the unit") {
  for (const int exponent : {-50, -30, 0, 30, 50}) {
    auto curve = bow();
    for (glm::vec4& p : curve.point)
      p *= std::exp2(static_cast<float>(exponent));
    const float error = std::ldexp(1e-4f, exponent);
    CHECK(pieces_within(curve, error, error) == pieces_within(bow(), 1e-4f, 1e-4f));
  }
}

TEST_CASE("NaN, infinities and second differences too large make one piece, of places and of radii each") {
  for (const float bad : {nan, inf, -inf, 1e30f}) {
    for (std::size_t k = 0; k < 4; ++k) {
      auto curve = bow();
      curve.point[k].y = bad;
      CHECK(pieces_within(curve, 1e-3f, 1e-3f) == 1u);
      CHECK(piece_error(curve, 1u) == 0.0f);
      curve = bow();
      curve.point[k].w = bad;
      CHECK(pieces_within(curve, 1e-3f, 1e-3f) == pieces_within(bow(), 1e-3f, inf));
    }
  }
}

TEST_CASE("points beyond the last piece are the curve's end") {
  CHECK(point_of_piece(bow(), 7u, 3u) == bow().point[3]);
  CHECK(point_of_piece(bow(), 0u, 0u) == bow().point[0]);
  CHECK(point_of_piece(bow(), 1u, 0u) == bow().point[3]);
}

}  // namespace pelage::test
