// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/lanes.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/vector_math.hpp>

#include "lane_bits.hpp"

namespace pelage::test {

TEST_CASE("functions of lanes are those of floats, bit for bit, whatever the float") {
  CHECK(same_bits_at_every_width(any_bits, [](auto x, auto) { return saturate(x); }));
  CHECK(same_bits_at_every_width(any_bits, [](auto x, auto) { return fast_log2(x); }));
  CHECK(same_bits_at_every_width(any_bits, [](auto x, auto) { return fast_exp2(x); }));
  CHECK(same_bits_at_every_width(any_bits, [](auto x, auto y) { return power_of_cosine(x, y); }));
}

TEST_CASE("functions of lanes are those of floats where they are not extreme") {
  CHECK(same_bits_at_every_width(floats_in(0.0F, 2.0F), [](auto x, auto) { return fast_log2(x); }));
  CHECK(same_bits_at_every_width(floats_in(-130.0F, 130.0F), [](auto x, auto) { return fast_exp2(x); }));
  CHECK(same_bits_at_every_width(floats_in(0.0F, 1.0F),
                                 [](auto x, auto y) { return power_of_cosine(x, decltype(y)(60.0f) * y); }));
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
