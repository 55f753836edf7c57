// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/visibility/layer_position.hpp>

#include "property.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

float any_float(std::uint32_t bits) {
  return std::bit_cast<float>(bits);
}

/// The laws of a position as a function of depth.
template <class Position>
void check_position(Position position, float a, float b, std::uint32_t layers) {
  const float at_a = position(a);
  const float at_b = position(b);
  RC_ASSERT(at_a >= 0.0f);
  RC_ASSERT(at_a <= static_cast<float>(layers));
  RC_ASSERT(!(a <= b) || at_a <= at_b);
  RC_ASSERT(layer_at(at_a, layers) < layers);
}

TEST_CASE("positions lie in [0, layers] and never fall, whatever the depth and the width") {
  holds("any bits", [](std::uint32_t a, std::uint32_t b, std::uint32_t w, std::uint8_t n) {
    const std::uint32_t layers = n + 1u;
    const float width = std::abs(any_float(w));
    const auto equal = [&](float offset) { return equal_layer_position(offset, width, layers); };
    const auto growing = [&](float offset) { return growing_layer_position(offset, width, layers); };
    const auto slice = [&](float relative) { return slice_position(relative, layers); };
    check_position(equal, any_float(a), any_float(b), layers);
    check_position(growing, any_float(a), any_float(b), layers);
    check_position(slice, any_float(a), any_float(b), layers);
    // Neighbours show a fall of rounding's size.
    check_position(growing, any_float(a), std::nextafter(any_float(a), inf), layers);
    check_position(equal, any_float(a), std::nextafter(any_float(a), inf), layers);
  });
}

TEST_CASE("growing layers never fall from float to float round every layer's end") {
  for (std::uint32_t layer = 1u; layer <= 64u; ++layer) {
    float offset = static_cast<float>(layer * (layer + 1u) / 2u);
    for (int step = 0; step < 16; ++step)
      offset = std::nextafter(offset, 0.0f);
    for (int step = 0; step < 32; ++step) {
      const float next = std::nextafter(offset, inf);
      CHECK(growing_layer_position(offset, 1.0f, 64u) <= growing_layer_position(next, 1.0f, 64u));
      offset = next;
    }
  }
}

TEST_CASE("a layer's end has its number as position, and its middle lies half between") {
  for (std::uint32_t layer = 0u; layer < 64u; ++layer) {
    const float k = static_cast<float>(layer);
    CHECK(equal_layer_position(0.25f * k, 0.25f, 64u) == k);
    CHECK(equal_layer_position(0.25f * (k + 0.5f), 0.25f, 64u) == k + 0.5f);
    const float begin = 0.25f * 0.5f * k * (k + 1.0f);
    CHECK(growing_layer_position(begin, 0.25f, 64u) == k);
    CHECK(growing_layer_position(begin + 0.125f * (k + 1.0f), 0.25f, 64u) == k + 0.5f);
    CHECK(slice_position(k / 64.0f, 64u) == k);
  }
}

TEST_CASE("growing layers fill their extent") {
  for (const std::uint32_t layers : {1u, 4u, 16u, 32u}) {
    const float width = growing_layer_width(8.0f, layers);
    CHECK(growing_layer_position(8.0f * 1.000001f, width, layers) == static_cast<float>(layers));
    CHECK(growing_layer_position(8.0f * 0.999f, width, layers) < static_cast<float>(layers));
  }
}

TEST_CASE("what has no place gets one") {
  CHECK(equal_layer_position(nan, 1.0f, 4u) == 0.0f);
  CHECK(growing_layer_position(nan, 1.0f, 4u) == 0.0f);
  CHECK(slice_position(nan, 4u) == 0.0f);
  CHECK(equal_layer_position(inf, 1.0f, 4u) == 4.0f);
  CHECK(growing_layer_position(inf, 1.0f, 4u) == 4.0f);
  CHECK(equal_layer_position(0.0f, 0.0f, 4u) == 0.0f);
  CHECK(equal_layer_position(1e-30f, 0.0f, 4u) == 4.0f);
  CHECK(growing_layer_position(1e-30f, 0.0f, 4u) == 4.0f);
  CHECK(equal_layer_position(1e30f, inf, 4u) == 0.0f);
  CHECK(equal_layer_position(1e38f, 1e38f, 4u) == 0.0f);
  CHECK(equal_layer_position(8e37f, 8e37f, 4u) == 1.0f);
  CHECK(equal_layer_position(0x1p126f, 0x1p126f, 4u) == 1.0f);
  CHECK(equal_layer_position(0x1.000002p126f, 0x1.000002p126f, 4u) == 0.0f);
  CHECK(layer_at(4.0f, 4u) == 3u);
}

}  // namespace pelage::test
