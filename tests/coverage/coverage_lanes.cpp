// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/lanes.hpp>
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>

#include "property.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pelage::test {

template <int W>
using values = std::array<float, W>;

/// Of either sign and any magnitude, now and then 0, so that cases meet at random in one vector.
float any_value() {
  const auto exponent = static_cast<float>(*rc::gen::inRange(-6, 5));
  const auto mantissa = static_cast<float>(*rc::gen::inRange(-1000, 1001)) / 1000.0f;
  return mantissa * std::exp2(exponent);
}

template <int W>
values<W> any_values() {
  values<W> all;
  for (float& one : all) {
    one = any_value();
  }
  return all;
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
float lane_of(lanes<W> all, std::size_t k) {
  values<W> out;
  all.store(out.data());
  return out[k];
}

/// -0 counts as 0: the sign of a zero is not part of the kernels' promise.
bool same_value(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

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
    RC_ASSERT(same_value(lane_of(found.along_ray, k), alone.along_ray));
    RC_ASSERT(same_value(lane_of(found.along_segment, k), alone.along_segment));
    RC_ASSERT(same_value(lane_of(found.distance, k), alone.distance));
  }
}

TEST_CASE("closest points of lanes are those of the kernel, bit for bit") {
  holds("4 lanes", check_closest_points<4>);
  holds("8 lanes", check_closest_points<8>);
  holds("16 lanes", check_closest_points<16>);
}

template <int W>
void check_shares() {
  constexpr float inf = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  values<W> offset = any_values<W>();
  values<W> fibre = any_values<W>();
  values<W> disc = any_values<W>();
  for (std::size_t k = 0; k < W; ++k) {  // most as a renderer has them; the rest keep their signs
    if (*rc::gen::inRange(0, 8) != 0) {
      disc[k] = std::abs(disc[k]);
      fibre[k] = disc[k] * std::exp2(static_cast<float>(*rc::gen::inRange(-40, 20)) / 8.0f);
      offset[k] = (disc[k] + fibre[k]) * static_cast<float>(*rc::gen::inRange(-1100, 1101)) / 1000.0f;
    }
  }
  for (values<W>* one : {&offset, &fibre, &disc}) {
    const auto k = static_cast<std::size_t>(*rc::gen::inRange(0, W));
    (*one)[k] = *rc::gen::element((*one)[k], 0.0f, inf, nan);
  }
  const lanes<W> found =
      disc_strip_share(lanes<W>::load(offset.data()), lanes<W>::load(fibre.data()), lanes<W>::load(disc.data()));
  for (std::size_t k = 0; k < W; ++k) {
    RC_LOG() << offset[k] << " " << fibre[k] << " " << disc[k];
    RC_ASSERT(same_value(lane_of(found, k), disc_strip_share(offset[k], fibre[k], disc[k])));
  }
}

TEST_CASE("shares of lanes are those of the kernel, bit for bit, and so is what no fibre has") {
  holds("4 lanes", check_shares<4>);
  holds("8 lanes", check_shares<8>);
  holds("16 lanes", check_shares<16>);
}

}  // namespace pelage::test
