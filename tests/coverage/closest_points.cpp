// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/lanes.hpp>
#include <pelage/coverage/closest_points.hpp>

#include "lane_bits.hpp"
#include "property.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pelage::test {

template <class Real>
struct ray_and_segment {
  glm::vec<3, Real> origin, direction, start, end;

  /// How far apart things are, by which rounding is measured.
  Real size() const { return glm::length(start - origin) + glm::length(end - origin); }
};

glm::dvec3 any_vector() {
  const auto coordinate = [] { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-1000, 1001)) * 0.001; };
  const double x = coordinate();
  const double y = coordinate();
  return glm::dvec3(x, y, coordinate());
}

/// A ray from about the segment's neighbourhood, at times parallel to it, at times along one axis, of any length.
template <class Real>
ray_and_segment<Real> any_ray_and_segment() {
  const double scale = std::pow(10.0, *rc::gen::inRange(-4, 5));
  const glm::dvec3 origin = scale * any_vector();
  const glm::dvec3 start = scale * any_vector();
  const glm::dvec3 end = *rc::gen::element(0.0, 1e-3, 1.0) * scale * any_vector() + start;
  const glm::dvec3 along = end - start;
  glm::dvec3 direction = *rc::gen::element(any_vector(), along, -along, along + 1e-4 * scale * any_vector());
  direction *= std::pow(10.0, *rc::gen::inRange(-3, 4));
  RC_PRE(glm::length(direction) > 1e-6);
  using vector = glm::vec<3, Real>;
  return {vector(origin), vector(direction), vector(start), vector(end)};
}

template <class Real>
closest_pair<Real> closest_of(const ray_and_segment<Real>& in) {
  return closest_points(in.origin, in.direction, in.start, in.end);
}

using exact_vector = glm::vec<3, long double>;

/// The least distance by search: that of a point on the segment from a ray is convex, so thirds close in on it.
template <class Real>
long double searched_distance(const ray_and_segment<Real>& in) {
  const exact_vector origin = in.origin;
  const exact_vector direction = glm::normalize(exact_vector(in.direction));
  const auto distance_at = [&](long double s) {
    const exact_vector point = exact_vector(in.start) + s * (exact_vector(in.end) - exact_vector(in.start));
    const long double along = std::max(0.0L, glm::dot(point - origin, direction));
    return glm::length(point - origin - along * direction);
  };
  long double low = 0.0L;
  long double high = 1.0L;
  while (high - low > 1e-15L) {
    const long double third = (high - low) / 3.0L;
    if (distance_at(low + third) < distance_at(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return std::min({distance_at(low), distance_at(0.0L), distance_at(1.0L)});
}

/// The distance between the two points that a pair names.
template <class Real>
long double distance_named(const ray_and_segment<Real>& in, closest_pair<Real> pair) {
  const exact_vector on_ray =
      exact_vector(in.origin) + static_cast<long double>(pair.along_ray) * exact_vector(in.direction);
  const exact_vector axis = exact_vector(in.end) - exact_vector(in.start);
  return glm::length(exact_vector(in.start) + static_cast<long double>(pair.along_segment) * axis - on_ray);
}

template <class Real>
void check_that_none_is_closer() {
  const ray_and_segment<Real> in = any_ray_and_segment<Real>();
  const closest_pair<Real> pair = closest_of(in);
  const long double tolerance = 8 * std::numeric_limits<Real>::epsilon() * in.size();
  RC_ASSERT(std::abs(pair.distance - searched_distance(in)) <= tolerance);
  RC_ASSERT(std::abs(pair.distance - distance_named(in, pair)) <= tolerance);
  RC_ASSERT(pair.along_ray >= Real(0) && pair.along_segment >= Real(0) && pair.along_segment <= Real(1));
}

TEST_CASE("no two points of ray and segment are closer, by search, within 8 ulp of their distance from the origin") {
  holds("in float", check_that_none_is_closer<float>);
  holds("in double", check_that_none_is_closer<double>);
}

/// Directions, and ends' distances from the origin, of 2^low to 2^high.
template <class Real>
void check_at_the_ends(int low, int high) {
  ray_and_segment<double> in = any_ray_and_segment<double>();
  const double nearest = std::min(glm::length(in.start - in.origin), glm::length(in.end - in.origin));
  const double farthest = std::max(glm::length(in.start - in.origin), glm::length(in.end - in.origin));
  RC_PRE(nearest > 0.0);
  const double scale = *rc::gen::element(std::exp2(low) / nearest, std::exp2(high) / farthest);
  using vector = glm::vec<3, Real>;
  const glm::dvec3 unit = in.direction / glm::length(in.direction);
  const ray_and_segment<Real> scaled{vector(0.0), vector(unit * std::exp2(*rc::gen::element(low, high))),
                                     vector((in.start - in.origin) * scale), vector((in.end - in.origin) * scale)};
  const long double tolerance = 8 * std::numeric_limits<Real>::epsilon() * scaled.size();
  const closest_pair<Real> pair = closest_of(scaled);
  RC_ASSERT(std::abs(pair.distance - searched_distance(scaled)) <= tolerance);
  RC_ASSERT(std::abs(pair.distance - distance_named(scaled, pair)) <= tolerance);
}

TEST_CASE("the same at both ends of the range of lengths") {
  holds("in float", [] { check_at_the_ends<float>(-20, 30); });
  holds("in double", [] { check_at_the_ends<double>(-150, 250); });
}

/// h as the ray's first hit of the fibre's cylinder has it: the sine of the angle between the normal there and the eye,
/// seen along the fibre. NaN where the ray misses.
double traced_offset(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& start,
                     const glm::dvec3& end, double radius) {
  const glm::dvec3 x = glm::normalize(end - start);
  const glm::dvec3 eye = -glm::normalize(direction);
  const glm::dvec3 y = glm::normalize(glm::cross(eye, x));
  const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, x) * x; };
  const glm::dvec3 from = across(origin - start);
  const glm::dvec3 step = across(direction);
  const double a = glm::dot(step, step);
  const double b = glm::dot(from, step);
  const double inside = b * b - a * (glm::dot(from, from) - radius * radius);
  return inside < 0.0 ? std::nan("") : glm::dot((from + (-b - std::sqrt(inside)) / a * step) / radius, y);
}

template <class Real>
void check_offset() {
  const glm::dvec3 start = any_vector();
  const glm::dvec3 end = start + any_vector();
  RC_PRE(glm::length(end - start) > 1e-2);
  const double radius = std::pow(10.0, *rc::gen::inRange(-3, 0));
  const glm::dvec3 through = glm::mix(start, end, 0.5) + 1.2 * radius * any_vector();
  const glm::dvec3 origin = through + 4.0 * any_vector();
  RC_PRE(glm::length(origin - through) > 2.5);
  using vector = glm::vec<3, Real>;
  const ray_and_segment<Real> in{vector(origin), vector((through - origin) * std::exp2(*rc::gen::inRange(-9, 9))),
                                 vector(start), vector(end)};
  RC_PRE(glm::length(glm::cross(glm::dvec3(in.end - in.start), glm::dvec3(in.direction))) >
         0.5 * glm::length(in.end - in.start) * glm::length(in.direction));
  const Real h = offset_across(in.origin, in.direction, in.start, in.end, closest_of(in), Real(radius));
  const double expected = traced_offset(in.origin, in.direction, in.start, in.end, double{Real(radius)});
  const double tolerance = 16.0 * double{std::numeric_limits<Real>::epsilon()} * double(in.size()) / radius;
  if (std::isnan(expected)) {
    RC_ASSERT(std::abs(std::abs(h) - 1.0) <= tolerance);
  } else {
    RC_ASSERT(std::abs(h - expected) <= tolerance + 1e-13 / radius);
  }
}

TEST_CASE("the offset across a fibre is that of the ray's hit on its cylinder, 1 or -1 where it misses") {
  holds("in float", check_offset<float>);
  holds("in double", check_offset<double>);
}

TEST_CASE("from +z, with the fibre along x, a ray on the side of +y has a positive offset") {
  const glm::vec3 start(-1.0f, 0.0f, 0.0f);
  const glm::vec3 end(1.0f, 0.0f, 0.0f);
  const auto offset_at = [&](float y, const glm::vec3& to, const glm::vec3& direction) {
    const glm::vec3 origin = glm::vec3(0.0f, y, 0.0f) - 4.0f * direction;
    return offset_across(origin, direction, start, to, closest_points(origin, direction, start, to), 0.5f);
  };
  const glm::vec3 ahead(0.0f, 0.0f, -1.0f);
  CHECK(offset_at(0.25f, end, ahead) == 0.5f);
  CHECK(offset_at(-0.25f, end, ahead) == -0.5f);
  CHECK(offset_at(0.0f, end, ahead) == 0.0f);
  CHECK(offset_at(3.0f, end, ahead) == 1.0f);
  CHECK(offset_at(-3.0f, end, ahead) == -1.0f);
  CHECK(offset_at(0.25f, start, ahead) == 0.0f);
  CHECK(offset_at(0.25f, end, glm::vec3(1.0f, 0.0f, 0.0f)) == 0.0f);
  CHECK(offset_at(std::numeric_limits<float>::quiet_NaN(), end, ahead) == 0.0f);
}

TEST_CASE("a longer direction only rescales the depth") {
  holds("bit for bit, by powers of two", [] {
    ray_and_segment<float> in = any_ray_and_segment<float>();
    const closest_pair<float> pair = closest_of(in);
    in.direction *= 8.0f;
    const closest_pair<float> scaled = closest_of(in);
    RC_ASSERT(scaled.along_ray * 8.0f == pair.along_ray);
    RC_ASSERT(scaled.along_segment == pair.along_segment && scaled.distance == pair.distance);
  });
}

TEST_CASE("with direction.z = -1 from the eye the depth is view depth") {
  holds("of the ray's point", [] {
    const glm::vec3 seen = glm::vec3(any_vector()) - glm::vec3(0.0f, 0.0f, 2.0f);
    const glm::vec3 direction = seen / -seen.z;
    // A segment through the ray's point, at right angles to the ray, is nearest there.
    const glm::vec3 side = glm::cross(direction, glm::vec3(0.6f, 0.8f, 0.0f));
    const closest_pair<float> pair = closest_points(glm::vec3(0.0f), direction, seen - side, seen + side);
    RC_ASSERT(relative_error(pair.along_ray, -seen.z) < 1e-6);
    RC_ASSERT(std::abs(pair.along_segment - 0.5f) < 1e-6f);
  });
}

TEST_CASE("of a parallel segment the point nearest to the ray's origin is meant, either way round") {
  const glm::vec3 origin(0.0f);
  const glm::vec3 direction(0.0f, 0.0f, -2.0f);
  const auto at = [](float z) { return glm::vec3(3.0f, 0.0f, z); };
  const auto is = [](closest_pair<float> pair, float along_ray, float along_segment, float distance) {
    return pair.along_ray == along_ray && pair.along_segment == along_segment && pair.distance == distance;
  };
  CHECK(is(closest_points(origin, direction, at(-4.0f), at(-8.0f)), 2.0f, 0.0f, 3.0f));
  CHECK(is(closest_points(origin, direction, at(-8.0f), at(-4.0f)), 2.0f, 1.0f, 3.0f));
  CHECK(is(closest_points(origin, direction, at(1.0f), at(-3.0f)), 0.0f, 0.25f, 3.0f));
  CHECK(is(closest_points(origin, direction, at(-3.0f), at(1.0f)), 0.0f, 0.75f, 3.0f));
  CHECK(is(closest_points(origin, direction, at(4.0f), at(8.0f)), 0.0f, 0.0f, 5.0f));
  CHECK(is(closest_points(origin, direction, at(8.0f), at(4.0f)), 0.0f, 1.0f, 5.0f));
}

TEST_CASE("a distance scales with all lengths from 2^-40 to 2^60, whatever the direction's length") {
  holds("by powers of two", [] {
    const ray_and_segment<float> in = any_ray_and_segment<float>();
    RC_PRE(in.size() > 0.0f);
    const int size = *rc::gen::inRange(-40, 59);
    const int length = *rc::gen::inRange(std::max(-60, -40 - size), std::min(60, 59 - size));
    const float scale = std::ldexp(1.0f, size - std::ilogb(in.size()));
    const float stretch = std::ldexp(1.0f, length - std::ilogb(glm::length(in.direction)));
    const ray_and_segment<float> scaled{scale * in.origin, stretch * in.direction, scale * in.start, scale * in.end};
    const float expected = scale * closest_of(in).distance;
    RC_ASSERT(std::abs(closest_of(scaled).distance - expected) <= 1e-6f * scaled.size());
  });
}

TEST_CASE("a segment of length 0 is a point") {
  holds("its distance from the ray", [] {
    ray_and_segment<float> in = any_ray_and_segment<float>();
    in.end = in.start;
    const closest_pair<float> pair = closest_of(in);
    RC_ASSERT(pair.along_segment == 0.0f);
    RC_ASSERT(std::abs(pair.distance - searched_distance(in)) <= 1e-6f * in.size());
  });
}

TEST_CASE("NaN anywhere gives a NaN depth and distance, and a place on the segment") {
  for (std::size_t i = 0; i < 12; ++i) {
    ray_and_segment<float> in{glm::vec3(0.0f), glm::vec3(0.1f, 0.2f, -1.0f), glm::vec3(1.0f, 2.0f, -3.0f),
                              glm::vec3(2.0f, -1.0f, -4.0f)};
    glm::vec3& vector = *std::array<glm::vec3*, 4>{&in.origin, &in.direction, &in.start, &in.end}[i / 3];
    vector[static_cast<int>(i % 3)] = std::numeric_limits<float>::quiet_NaN();
    const closest_pair<float> pair = closest_of(in);
    CHECK(std::isnan(pair.along_ray));
    CHECK(std::isnan(pair.distance));
    CHECK((pair.along_segment >= 0.0f && pair.along_segment <= 1.0f));
  }
}

template <int W>
struct any_points {
  values<W> x = any_values<W>(), y = any_values<W>(), z = any_values<W>();

  [[nodiscard]] lane_vector<W> packed() const {
    return {lanes<W>::load(x.data()), lanes<W>::load(y.data()), lanes<W>::load(z.data())};
  }
  [[nodiscard]] glm::vec3 at(std::size_t k) const { return {x[k], y[k], z[k]}; }
};

template <int W>
void check_closest_points() {
  const any_points<W> origin, direction, start;
  any_points<W> end;
  const auto special = static_cast<std::size_t>(*rc::gen::inRange(0, W));
  switch (*rc::gen::inRange(0, 3)) {
    case 0:  // a point
      end.x[special] = start.x[special], end.y[special] = start.y[special], end.z[special] = start.z[special];
      break;
    case 1:  // along the ray
      end.x[special] = start.x[special] + direction.x[special];
      end.y[special] = start.y[special] + direction.y[special];
      end.z[special] = start.z[special] + direction.z[special];
      break;
    default:
      break;
  }
  const closest_pair<lanes<W>> found =
      closest_points(origin.packed(), direction.packed(), start.packed(), end.packed());
  for (std::size_t k = 0; k < W; ++k) {
    const closest_pair<float> alone = closest_points(origin.at(k), direction.at(k), start.at(k), end.at(k));
    RC_ASSERT(same_value(found.along_ray.lane[k], alone.along_ray));
    RC_ASSERT(same_value(found.along_segment.lane[k], alone.along_segment));
    RC_ASSERT(same_value(found.distance.lane[k], alone.distance));
  }
}

TEST_CASE("closest points of lanes are those of the kernel, bit for bit") {
  holds("4 lanes", check_closest_points<4>);
  holds("8 lanes", check_closest_points<8>);
  holds("16 lanes", check_closest_points<16>);
}

}  // namespace pelage::test
