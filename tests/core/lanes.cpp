// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/lanes.hpp>

#include "lane_bits.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <random>

using namespace pelage;
using namespace pelage::test;

TEST_CASE("arithmetic on lanes is that on floats") {
  CHECK(same_bits_at_every_width(floats_in(-10.0f, 10.0f), [](auto a, auto b) { return a * b + a / b - b; }));
}

TEST_CASE("selection takes each lane by its own condition") {
  CHECK(same_bits_at_every_width(floats_in(-10.0f, 10.0f), [](auto a, auto b) { return select(a < b, a, b * b); }));
  CHECK(same_bits_at_every_width(floats_in(-10.0f, 10.0f), [](auto a, auto b) { return select(a > b, a, b * b); }));
}

TEST_CASE("square roots, whole parts and powers of two of lanes are those of floats") {
  CHECK(same_bits_at_every_width(floats_in(0.0f, 1e9f), [](auto a, auto) { return square_root(a); }));
  CHECK(same_bits_at_every_width(floats_in(-1e6f, 1e6f), [](auto a, auto) { return whole_part(a); }));
  CHECK(same_bits_at_every_width(floats_in(0.0f, 255.9f),
                                 [](auto a, auto) { return split_exponent(a).power + split_exponent(a).whole; }));
}

TEST_CASE("the elementary functions of lanes are those of floats, bit for bit") {
  CHECK(same_bits_at_every_width(floats_in(-120.0f, 100.0f), [](auto a, auto) { return exponential(a); }));
  CHECK(same_bits_at_every_width(floats_in(0.0f, 2.0f), [](auto a, auto) { return one_minus_exponential(a); }));
  CHECK(same_bits_at_every_width(floats_in(-1.0f, 1.0f), [](auto a, auto b) { return angle_of(a, b); }));
  CHECK(same_bits_at_every_width(any_bits, [](auto a, auto b) { return angle_of(a, b); }));
  CHECK(same_bits_at_every_width(floats_in(-50.0f, 50.0f), [](auto a, auto) { return rotation_by(a).sine; }));
}

TEST_CASE("a number fills every lane") {
  std::array<float, 8> found;
  lanes<8>(2.5).store(found.data());
  for (const float lane : found) {
    CHECK(lane == 2.5f);
  }
}

namespace {

/// True if a mask read as a number has just the bits of the lanes whose condition holds.
template <int W>
bool bits_tell_lanes() {
  std::mt19937 generator(static_cast<std::uint32_t>(W));
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t wanted = static_cast<std::uint32_t>(generator()) & all_bits<W>();
    std::array<float, W> a;
    for (std::uint32_t k = 0; k < W; ++k) {
      a[k] = (wanted >> k & 1u) != 0u ? -1.0f : 1.0f;
    }
    if (bits(lanes<W>::load(a.data()) < lanes<W>(0.0f)) != wanted) {
      return false;
    }
  }
  return bits(lanes<W>(1.0f) < lanes<W>(2.0f)) == all_bits<W>();
}

}  // namespace

TEST_CASE("a mask's bits are the lanes for which it holds") {
  CHECK(bits_tell_lanes<4>());
  CHECK(bits_tell_lanes<8>());
  CHECK(bits_tell_lanes<16>());
}
