// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/segment_quad.hpp>

#include "property.hpp"
#include "sweep.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pelage::test {

using corners = std::array<glm::dvec3, 4>;

/// A segment as expand_segment takes it.
struct fibre_piece {
  glm::dvec3 start, end;
  double fibre_radius;
  ray_cone<double> cone;
  double near_plane, margin;
};

template <class Real>
segment_quad<Real> quad_of(const fibre_piece& in) {
  using vector = glm::vec<3, Real>;
  const ray_cone<Real> cone{static_cast<Real>(in.cone.base), static_cast<Real>(in.cone.slope)};
  return expand_segment(vector(in.start), vector(in.end), static_cast<Real>(in.fibre_radius), cone,
                        static_cast<Real>(in.near_plane), static_cast<Real>(in.margin));
}

/// The same piece as float holds it.
fibre_piece as_float(const fibre_piece& in) {
  const auto held = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  return {glm::dvec3(glm::vec3(in.start)),           glm::dvec3(glm::vec3(in.end)), held(in.fibre_radius),
          {held(in.cone.base), held(in.cone.slope)}, held(in.near_plane),           in.margin};
}

template <class Real>
corners corners_of(const segment_quad<Real>& quad) {
  corners points;
  std::copy(quad.corner.begin(), quad.corner.end(), points.begin());
  return points;
}

double draw_even() {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'000)) * 1e-6;
}

double draw_between(double lower, double upper) {
  return lower + (upper - lower) * draw_even();
}

double draw_on_log_scale(double lower, double upper) {
  return on_log_scale(draw_even(), lower, upper);
}

glm::dvec3 draw_direction() {
  const double u = draw_even();
  return on_sphere(u, draw_even());
}

/// Segments of all lengths and directions round and behind the near plane, some seen end on, some of length 0.
fibre_piece draw_piece(ray_cone<double> cone) {
  const double depth = draw_on_log_scale(0.05, 100.0);
  const double aside = *rc::gen::element(0.01, 2.0);
  const glm::dvec3 start = depth * glm::dvec3(draw_between(-aside, aside), draw_between(-aside, aside), -1.0);
  const glm::dvec3 to_eye = cone.slope > 0.0 ? glm::normalize(start) : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 direction =
      *rc::gen::element(draw_direction(), draw_direction(), to_eye, -to_eye,
                        glm::normalize(to_eye + draw_on_log_scale(1e-7, 1e-2) * draw_direction()), glm::dvec3(0.0));
  const double length = depth * draw_on_log_scale(1e-4, 10.0);
  const double fibre_radius = *rc::gen::element(0.0, depth) * draw_on_log_scale(1e-5, 0.5);
  return {start, start + length * direction, fibre_radius, cone, 0.1, *rc::gen::element(0.5, 1.0, 2.0)};
}

fibre_piece draw_perspective_piece() {
  return draw_piece(ray_cone<double>{0.0, draw_on_log_scale(1e-5, 0.3)});
}

/// A thick fibre that the eye sees almost end on, under pixels too small to cover up for rounding.
fibre_piece draw_end_on_piece() {
  fibre_piece in = draw_piece(ray_cone<double>{0.0, 1e-5});
  const glm::dvec3 direction = glm::normalize(in.start) + draw_on_log_scale(1e-6, 1e-4) * draw_direction();
  in.end = in.start + draw_on_log_scale(0.01, 1.0) * glm::length(in.start) * direction;
  in.fibre_radius = 0.3 * glm::length(in.start);
  in.margin = 0.5;
  return in;
}

fibre_piece draw_orthographic_piece() {
  return draw_piece(ray_cone<double>{draw_on_log_scale(1e-4, 1.0), 0.0});
}

/// The part in front of the near plane. At least one end must be.
std::array<glm::dvec3, 2> in_front(const fibre_piece& in) {
  const auto held = [&](glm::dvec3 end, glm::dvec3 other) {
    const double behind = end.z + in.near_plane;
    return behind <= 0.0 ? end : end + (other - end) * (behind / (end.z - other.z));
  };
  return {held(in.start, in.end), held(in.end, in.start)};
}

struct ray {
  glm::dvec3 origin, direction;  ///< direction.z = -1
};

/// The ray of the pixel whose centre shows this point.
ray through(glm::dvec3 point, ray_cone<double> cone) {
  if (cone.slope > 0.0) return {glm::dvec3(0.0), point / -point.z};
  return {glm::dvec3(point.x, point.y, 0.0), glm::dvec3(0.0, 0.0, -1.0)};
}

/// True if the quad, seen from the ray's origin, covers the ray: inside all four planes through eye and edge.
bool covers(const corners& corner, ray r, bool perspective) {
  const auto seen = [&](glm::dvec3 point) {
    return perspective ? glm::normalize(point) : glm::dvec3(point.x, point.y, -1.0);
  };
  const glm::dvec3 looked_at = perspective ? r.direction : glm::dvec3(r.origin.x, r.origin.y, -1.0);
  const glm::dvec3 middle = seen(corner[0]) + seen(corner[1]) + seen(corner[2]) + seen(corner[3]);
  for (std::size_t i = 0; i < 4u; ++i) {
    const glm::dvec3 plane = glm::cross(seen(corner[i]), seen(corner[(i + 1u) % 4u]));
    if (glm::dot(plane, middle) * glm::dot(plane, looked_at) < 0.0) return false;
  }
  return true;
}

/// The angle between the outermost points of a quad along the fibre, seen from the eye, in degrees.
double span_in_degrees(const corners& corner) {
  const glm::dvec3 first = glm::normalize(corner[0] + corner[1]);
  const glm::dvec3 last = glm::normalize(corner[2] + corner[3]);
  return 57.29577951308232 * std::acos(std::clamp(glm::dot(first, last), -1.0, 1.0));
}

/// Looks for a pixel that the fibre touches and its quad misses, among pixels whose centres lie just inside the reach
/// of the fibre, all round its axis and beyond its ends.
template <class Real>
void check_that_no_pixel_is_missed(const fibre_piece& in) {
  const bool perspective = in.cone.slope > 0.0;
  const segment_quad<Real> quad = quad_of<Real>(in);
  const bool visible = std::min(in.start.z, in.end.z) <= -in.near_plane;
  RC_ASSERT(quad.visible == visible);
  RC_PRE(visible);
  const corners corner = corners_of(quad);
  for (const glm::dvec3& point : corner) {
    RC_ASSERT(std::isfinite(glm::length(point)));
  }
  RC_PRE(!perspective || span_in_degrees(corner) < 170.0);
  const auto [first, last] = in_front(in);
  // What float rounds, or the 1e-6 radians by which a segment counts as seen end on.
  const double slack = (perspective ? 3e-6 : 1e-6) * (glm::length(in.start) + glm::length(in.end));
  for (int i = 0; i < 300; ++i) {
    const auto [u, v, w, inside] = even_point<4>(i);
    const glm::dvec3 axis_point = first + std::clamp(1.5 * u - 0.25, 0.0, 1.0) * (last - first);
    const double radius = in.fibre_radius + radius_at(in.cone, -axis_point.z);
    // Where the ray that touches a ball of this radius passes its centre at right angles to the ray to the centre.
    const double sine = perspective ? std::min(0.999, radius / glm::length(axis_point)) : 0.0;
    const double touching = radius / std::sqrt(1.0 - sine * sine);
    const glm::dvec3 aside = glm::normalize(glm::cross(through(axis_point, in.cone).direction, on_sphere(v, w)));
    const glm::dvec3 shown = axis_point + (1.0 - on_log_scale(inside, 1e-4, 0.3)) * touching * aside;
    if (shown.z >= 0.0) continue;
    const ray r = through(shown, in.cone);
    const closest_pair<double> pair = closest_points(r.origin, r.direction, first, last);
    if (pair.distance < in.fibre_radius + radius_at(in.cone, pair.along_ray) - slack) {
      RC_ASSERT(covers(corner, r, perspective));
    }
  }
}

TEST_CASE("every pixel whose disc the fibre can touch has its centre inside the quad") {
  holds("perspective, float", [] { check_that_no_pixel_is_missed<float>(as_float(draw_perspective_piece())); });
  holds("perspective, double", [] { check_that_no_pixel_is_missed<double>(draw_perspective_piece()); });
  holds("almost end on, float", [] { check_that_no_pixel_is_missed<float>(as_float(draw_end_on_piece())); });
  holds("orthographic, float", [] { check_that_no_pixel_is_missed<float>(as_float(draw_orthographic_piece())); });
  holds("orthographic, double", [] { check_that_no_pixel_is_missed<double>(draw_orthographic_piece()); });
}

TEST_CASE("a fibre that passes close by the eye from far left to far right is still seen ahead") {
  for (const double near_end : {0.1, 0.11, 0.2}) {
    const glm::dvec3 start(-100.0, 0.0, -0.1);
    const glm::dvec3 end(100.0, 0.0, -near_end);
    const fibre_piece piece{start, end, 0.09, ray_cone<double>{0.0, 1e-2}, 0.1, 2.0};
    CHECK(covers(corners_of(quad_of<double>(piece)), ray{glm::dvec3(0.0), glm::dvec3(0.0, 0.0, -1.0)}, true));
  }
}

/// The area of the projected quad, in pixels.
double pixels_covered(const corners& corner, ray_cone<double> cone) {
  std::array<glm::dvec2, 4> point;
  for (std::size_t i = 0; i < 4u; ++i) {
    const double radius = radius_at(cone, -corner[i].z);
    point[i] = glm::dvec2(corner[i].x, corner[i].y) / (2.0 * radius);
  }
  const glm::dvec2 a = point[2] - point[0];
  const glm::dvec2 b = point[3] - point[1];
  return 0.5 * std::abs(a.x * b.y - a.y * b.x);
}

/// The least that a rectangle round segment, fibre and margin can cover, in pixels, with the fibre as wide all along
/// as at its nearer end.
double pixels_needed(const fibre_piece& in) {
  const double first = 2.0 * radius_at(in.cone, -in.start.z);
  const double last = 2.0 * radius_at(in.cone, -in.end.z);
  const double half_width = in.fibre_radius / std::min(first, last) + in.margin;
  const glm::dvec2 from = glm::dvec2(in.start.x, in.start.y) / first;
  const glm::dvec2 to = glm::dvec2(in.end.x, in.end.y) / last;
  return (glm::length(to - from) + 2.0 * half_width) * 2.0 * half_width;
}

/// A short thin fibre within 45 degrees of the view's axis, as hair is.
fibre_piece draw_ordinary_piece(ray_cone<double> cone) {
  const double depth = draw_on_log_scale(1.0, 100.0);
  const glm::dvec3 start = depth * glm::dvec3(draw_between(-0.7, 0.7), draw_between(-0.7, 0.7), -1.0);
  const glm::dvec3 end = start + 0.05 * depth * draw_even() * draw_direction();
  return {start, end, depth * draw_on_log_scale(1e-5, 1e-2), cone, 0.1, 2.0};
}

template <class Draw>
void check_that_few_pixels_are_wasted(Draw draw_cone, double factor) {
  const fibre_piece in = draw_ordinary_piece(draw_cone());
  RC_ASSERT(pixels_covered(corners_of(quad_of<double>(in)), in.cone) < factor * pixels_needed(in));
}

TEST_CASE("an ordinary fibre's quad covers little more than the rectangle round it") {
  holds("perspective", [] {
    check_that_few_pixels_are_wasted([] { return ray_cone<double>{0.0, draw_on_log_scale(1e-4, 1e-2)}; }, 1.75);
  });
  holds("orthographic", [] {
    check_that_few_pixels_are_wasted([] { return ray_cone<double>{draw_on_log_scale(1e-4, 1e-1), 0.0}; }, 1.001);
  });
}

TEST_CASE("a fibre seen end on, or of length 0, gives a square that faces the eye") {
  holds("four equal sides and two equal diagonals, at right angles to the view", [] {
    fibre_piece in = draw_ordinary_piece(*rc::gen::element(ray_cone<double>{0.0, 1e-3}, ray_cone<double>{1e-2, 0.0}));
    const glm::dvec3 view = in.cone.slope > 0.0 ? glm::normalize(in.start) : glm::dvec3(0.0, 0.0, -1.0);
    in.end = in.start + *rc::gen::element(0.0, 1.0) * view;
    const corners corner = corners_of(quad_of<double>(in));
    corners square = corner;
    for (glm::dvec3& point : square) {
      point -= (glm::dot(point, view) - glm::dot(in.start, view)) * view;
    }
    const auto seen_size = [&](std::size_t i) { return in.cone.slope > 0.0 ? glm::length(corner[i]) : 1.0; };
    for (std::size_t i = 0; i < 4u; ++i) {
      const double half = glm::length(square[i] - in.start) / seen_size(i);
      RC_ASSERT(relative_error(half, glm::length(square[0] - in.start) / seen_size(0)) < 1e-4);
    }
  });
}

bool is_nothing(const segment_quad<float>& quad) {
  return !quad.visible && std::all_of(quad.corner.begin(), quad.corner.end(),
                                      [](const glm::vec3& corner) { return corner == glm::vec3(0.0f); });
}

TEST_CASE("what lies nearer than the near plane gives no quad") {
  holds("both ends nearer, or behind", [] {
    fibre_piece in = *rc::gen::element(0, 1) == 0 ? draw_perspective_piece() : draw_orthographic_piece();
    in.near_plane = 1.001 * std::max(-in.start.z, -in.end.z);
    RC_PRE(in.near_plane > 1e-3);
    RC_ASSERT(is_nothing(quad_of<float>(in)));
  });
}

TEST_CASE("NaN or infinite ends or radius give no quad") {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 7; ++i) {
      fibre_piece in{glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(1.0, 2.0, -3.0), 0.01, {0.0, 0.01}, 0.1, 2.0};
      (i < 3 ? in.start[i] : i < 6 ? in.end[i - 3] : in.fibre_radius) = bad;
      CHECK(is_nothing(quad_of<float>(in)));
    }
  }
}

TEST_CASE("the reach is the fibre's radius and the margin's pixels") {
  CHECK(reach_at(10.0, 0.25, ray_cone<double>{0.0, 0.01}, 2.0) == doctest::Approx((0.25 + 2.0 * 2.0 * 0.1) / 0.99));
  CHECK(reach_at(10.0, 0.25, ray_cone<double>{0.5, 0.0}, 1.5) == doctest::Approx(0.25 + 1.5 * 2.0 * 0.5));
}

TEST_CASE("the stretch is that of the tangents from the eye to a ball") {
  worst_case worst;
  for (int i = 0; i < 1000; ++i) {
    const double reach = 0.001 + 0.998 * even_point<1>(i)[0];
    worst.see(relative_error(tangent_stretch(reach), std::tan(std::asin(reach)) / reach), {reach});
  }
  CHECK_MESSAGE(worst.error < 1e-11, worst);
  for (const double reach : {1.0, 2.0, HUGE_VAL}) {
    CHECK(tangent_stretch(reach) == 1000.0);
  }
}

TEST_CASE("any_normal is a unit vector at right angles") {
  for (int i = 0; i < 1000; ++i) {
    const auto [u, v] = even_point<2>(i);
    for (const glm::dvec3 direction : {on_sphere(u, v), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(-1.0, 0.0, 0.0)}) {
      CHECK(glm::length(any_normal(direction)) == doctest::Approx(1.0).epsilon(1e-12));
      CHECK(std::abs(glm::dot(any_normal(direction), direction)) < 1e-12);
    }
  }
}

}  // namespace pelage::test
