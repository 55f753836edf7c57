// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/mixed_bits.hpp>
#include <pelage/visibility/lookup_jitter.hpp>

#include "property.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pelage::test {

TEST_CASE("jitter stays within half a texel, whatever the seed") {
  holds("any seed", [](std::uint32_t seed) {
    const glm::vec2 j = lookup_jitter(seed);
    RC_ASSERT(j.x >= -0.5f);
    RC_ASSERT(j.x < 0.5f);
    RC_ASSERT(j.y >= -0.5f);
    RC_ASSERT(j.y < 0.5f);
  });
}

TEST_CASE("neighbouring seeds fill the square evenly") {
  constexpr std::uint32_t seeds = 64000u;
  std::array<int, 64> cell{};
  for (std::uint32_t seed = 0u; seed < seeds; ++seed) {
    const glm::vec2 j = lookup_jitter(seed);
    ++cell[static_cast<std::size_t>((j.y + 0.5f) * 8.0f) * 8u + static_cast<std::size_t>((j.x + 0.5f) * 8.0f)];
  }
  for (const int count : cell) {
    CHECK(std::abs(count - 1000) < 160);  // five standard deviations
  }
}

TEST_CASE("each bit of a number turns each mixed bit in half the cases") {
  std::array<int, 1024> turned{};
  for (std::uint32_t x = 1u; x <= 2000u; ++x) {
    for (std::uint32_t bit = 0u; bit < 32u; ++bit) {
      const std::uint32_t difference = mixed_bits(x) ^ mixed_bits(x ^ (1u << bit));
      for (std::uint32_t i = 0u; i < 32u; ++i) {
        turned[bit * 32u + i] += static_cast<int>((difference >> i) & 1u);
      }
    }
  }
  for (const int count : turned) {
    CHECK(std::abs(count - 1000) < 200);
  }
}

}  // namespace pelage::test
