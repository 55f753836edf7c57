// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/vector_math.hpp>

#include <glm/geometric.hpp>

#include <cmath>

#include "lane_bits.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

glm::vec3 any_vector() {
  const auto part =
      rc::gen::map(rc::gen::inRange(-1000000, 1000001), [](int i) { return 1e-5f * static_cast<float>(i); });
  return {*part, *part, *part};
}

}  // namespace

TEST_CASE("Products and lengths have the bits of GLM's") {
  holds("GLM", [] {
    const glm::vec3 a = any_vector();
    const glm::vec3 b = any_vector();
    RC_ASSERT(dot_product(a, b) == glm::dot(a, b));
    RC_ASSERT(cross_product(a, b) == glm::cross(a, b));
    RC_ASSERT(vector_length(a) == glm::length(a));
    RC_PRE(a != glm::vec3(0.0f));
    RC_ASSERT(unit_vector(a) == glm::normalize(a));
  });
}

TEST_CASE("A vector has no cross product with itself or its multiples by powers of two, to the last bit") {
  holds("parallel", [] {
    const glm::vec3 a = any_vector();
    RC_ASSERT(cross_product(a, a) == glm::vec3(0.0f));
    RC_ASSERT(cross_product(a, -0.5f * a) == glm::vec3(0.0f));
  });
}

TEST_CASE("A cross product is at right angles to both its factors") {
  holds("right angles", [] {
    const glm::dvec3 a(any_vector());
    const glm::dvec3 b(any_vector());
    const glm::dvec3 c = cross_product(a, b);
    const double bound = 1e-14 * vector_length(a) * vector_length(b);
    RC_ASSERT(std::abs(dot_product(c, a)) <= bound * vector_length(a));
    RC_ASSERT(std::abs(dot_product(c, b)) <= bound * vector_length(b));
  });
}

TEST_CASE("A unit vector has length 1 and its vector's direction; that of 0 is NaN") {
  holds("unit", [] {
    const glm::vec3 a = any_vector();
    RC_PRE(vector_length(a) > 0.01f);
    const glm::dvec3 unit(unit_vector(a));
    RC_ASSERT(std::abs(vector_length(unit) - 1.0) < 3e-7);
    RC_ASSERT(vector_length(cross_product(unit, glm::dvec3(a))) < 3e-7 * vector_length(glm::dvec3(a)));
  });
  CHECK(std::isnan(unit_vector(glm::vec3(0.0f)).x));
}

TEST_CASE("products of lanes are those of vectors, bit for bit") {
  const auto vectors = [](auto x, auto y) {
    using vector = glm::vec<3, decltype(x), glm::defaultp>;
    const vector a(x, y, x * y);
    const vector b(y + x, x - y, x);
    const vector c = cross_product(a, b) + unit_vector(a);
    return (c.x + c.y) * c.z + dot_product(a, b) + vector_length(b);
  };
  CHECK(same_bits_at_every_width(floats_in(-10.0F, 10.0F), vectors));
}

}  // namespace pelage::test
