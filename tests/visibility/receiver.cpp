// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/lanes.hpp>
#include <pelage/coverage/closest_points.hpp>
#include <pelage/visibility/receiver.hpp>

#include "lane_bits.hpp"
#include "property.hpp"

#include <glm/glm.hpp>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pelage::test {

namespace {

constexpr double no_limit = 65536.0;

double any_number(double lower, double upper) {
  return lower + (upper - lower) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1 << 24)) * 0x1p-24;
}

/// Of length 1, in any direction, steep ones often.
glm::dvec3 any_direction() {
  const double sine = *rc::gen::arbitrary<bool>() ? any_number(0.0, 1.0) : std::exp2(any_number(-10.0, 0.0));
  const double turn = any_number(0.0, 6.283);
  const double cosine = std::sqrt(1.0 - sine * sine);
  return {sine * std::cos(turn), sine * std::sin(turn), *rc::gen::arbitrary<bool>() ? cosine : -cosine};
}

/// A place that light reaches, and the rays beside it.
struct lit_place {
  bool perspective = *rc::gen::arbitrary<bool>();
  double depth = any_number(1.0, 100.0);
  glm::dvec3 ray =
      perspective ? glm::dvec3(any_number(-0.5, 0.5), any_number(-0.5, 0.5), -1.0) : glm::dvec3(0.0, 0.0, -1.0);
  glm::dvec3 place = perspective ? depth * ray : glm::dvec3(any_number(-9.0, 9.0), any_number(-9.0, 9.0), -depth);

  [[nodiscard]] glm::dvec3 origin_beside(const glm::dvec2& offset) const {
    return perspective ? glm::dvec3(0.0) : glm::dvec3(place.x + offset.x, place.y + offset.y, 0.0);
  }
  [[nodiscard]] glm::dvec3 ray_beside(const glm::dvec2& offset) const {
    return perspective ? ray + glm::dvec3(offset / depth, 0.0) : ray;
  }
};

glm::dvec2 any_offset() {
  return {any_number(-1.0, 1.0), any_number(-1.0, 1.0)};
}

}  // namespace

TEST_CASE("a line's slope is the growth of a fragment's depth from ray to ray") {
  holds("differences of closest_points", [] {
    const lit_place at;
    const glm::dvec3 tangent = any_direction();
    const glm::dvec2 slope = line_depth_slope(at.ray, any_number(0.01, 200.0) * tangent, no_limit);
    const double step = 1e-6 * at.depth / (1.0 + glm::dot(slope, slope));
    const glm::dvec2 offset = step * any_offset();
    const double reach = 0.3 * at.depth;
    const auto depth_beside = [&](const glm::dvec2& by) {
      return closest_points(at.origin_beside(by), at.ray_beside(by), at.place - reach * tangent,
                            at.place + reach * tangent)
          .along_ray;
    };
    const double growth = 0.5 * (depth_beside(offset) - depth_beside(-offset));
    RC_ASSERT(std::abs(growth - glm::dot(slope, offset)) < 1e-4 * step * (1.0 + glm::length(slope)));
  });
}

TEST_CASE("in an orthographic map a line's depth is known at any distance") {
  holds("closest_points far beside", [] {
    lit_place at;
    if (at.perspective) return;
    const glm::dvec3 tangent = any_direction();
    const glm::dvec2 slope = line_depth_slope(at.ray, tangent, no_limit);
    const glm::dvec2 offset = 0.1 * at.depth / (1.0 + glm::length(slope)) * any_offset();
    const double depth = closest_points(at.origin_beside(offset), at.ray, at.place - 0.5 * at.depth * tangent,
                                        at.place + 0.5 * at.depth * tangent)
                             .along_ray;
    RC_ASSERT(std::abs(depth - (at.depth + glm::dot(slope, offset))) < 1e-9 * at.depth);
  });
}

TEST_CASE("a plane's slope is the growth of the depth at which rays meet it") {
  holds("differences of intersections", [] {
    const lit_place at;
    const glm::dvec3 normal = any_direction();
    const double facing = std::abs(glm::dot(normal, at.ray));
    RC_PRE(facing > 1e-3);
    const glm::dvec2 slope = plane_depth_slope(at.ray, any_number(0.01, 200.0) * normal, no_limit);
    const glm::dvec2 offset = 1e-6 * at.depth * facing * facing * any_offset();
    const auto depth_beside = [&](const glm::dvec2& by) {
      return glm::dot(normal, at.place - at.origin_beside(by)) / glm::dot(normal, at.ray_beside(by));
    };
    const double growth = 0.5 * (depth_beside(offset) - depth_beside(-offset));
    RC_ASSERT(std::abs(growth - glm::dot(slope, offset)) < 1e-9 * at.depth * facing);
  });
}

TEST_CASE(
    "no slope is steeper than the limit, one below it is free of it, and the sign of a direction does not matter") {
  holds("floats", [] {
    const glm::vec3 ray(lit_place().ray);
    const glm::vec3 direction(any_direction());
    const auto steepest = static_cast<float>(std::exp2(any_number(-2.0, 16.0)));
    const auto check = [&](auto slope_of) {
      const glm::vec2 slope = slope_of(ray, direction, steepest);
      const glm::vec2 free = slope_of(ray, direction, 65536.0F);
      RC_ASSERT(glm::length(slope) <= steepest * 1.00001F);
      if (glm::length(free) < 0.999F * steepest) RC_ASSERT(slope == free);
      if (glm::length(free) > 1.001F * steepest && glm::length(free) < 65000.0F) {
        RC_ASSERT(glm::length(slope) * glm::length(free) < 1.001F * steepest * steepest);
        RC_ASSERT(glm::dot(slope, free) > 0.999F * glm::length(slope) * glm::length(free));
      }
      RC_ASSERT(slope_of(ray, -direction, steepest) == slope);
    };
    check([](auto... in) { return line_depth_slope(in...); });
    check([](auto... in) { return plane_depth_slope(in...); });
  });
}

TEST_CASE("end on, and without a direction, the slope is 0, of NaN it is NaN") {
  const glm::vec3 ray(0.25F, -0.5F, -1.0F);
  const glm::vec2 level(0.0F);
  CHECK(line_depth_slope(ray, ray, 64.0F) == level);
  CHECK(line_depth_slope(ray, -2.0F * ray, 64.0F) == level);
  CHECK(line_depth_slope(ray, glm::vec3(0.0F), 64.0F) == level);
  CHECK(plane_depth_slope(ray, glm::vec3(2.0F, 1.0F, 0.0F), 64.0F) == level);  // a plane that holds the ray
  CHECK(plane_depth_slope(ray, glm::vec3(0.0F), 64.0F) == level);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 3; ++i) {
    glm::vec3 direction(0.3F, 0.2F, 0.1F);
    direction[i] = nan;
    CHECK(std::isnan(line_depth_slope(ray, direction, 64.0F).x));
    CHECK(std::isnan(plane_depth_slope(ray, direction, 64.0F).x));
  }
}

template <int W>
void check_lanes() {
  std::array<values<W>, 6> in;
  for (values<W>& one : in)
    one = any_values<W>();
  const auto packed = [&](std::size_t i) { return lanes<W>::load(in[i].data()); };
  const glm::vec<3, lanes<W>> ray(packed(0), packed(1), packed(2));
  const glm::vec<3, lanes<W>> direction(packed(3), packed(4), packed(5));
  const auto line = line_depth_slope(ray, direction, lanes<W>(64.0F));
  const auto plane = plane_depth_slope(ray, direction, lanes<W>(64.0F));
  for (std::size_t k = 0; k < W; ++k) {
    const glm::vec3 one_ray(in[0][k], in[1][k], in[2][k]);
    const glm::vec3 one(in[3][k], in[4][k], in[5][k]);
    const glm::vec2 alone_line = line_depth_slope(one_ray, one, 64.0F);
    const glm::vec2 alone_plane = plane_depth_slope(one_ray, one, 64.0F);
    RC_ASSERT((same_value(line.x.lane[k], alone_line.x) && same_value(line.y.lane[k], alone_line.y)));
    RC_ASSERT((same_value(plane.x.lane[k], alone_plane.x) && same_value(plane.y.lane[k], alone_plane.y)));
  }
}

TEST_CASE("slopes of lanes are those of the formula, bit for bit") {
  holds("4 lanes", check_lanes<4>);
  holds("8 lanes", check_lanes<8>);
  holds("16 lanes", check_lanes<16>);
}

}  // namespace pelage::test
