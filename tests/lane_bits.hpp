// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lanes.hpp>

#include "property.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

/// Lanes against floats: what the tests of functions with both share.
namespace pelage::test {

/// Any float, NaN, infinities and denormals included; every fourth a power of two or beside one.
inline float any_bits(std::mt19937& random) {
  const auto word = static_cast<std::uint32_t>(random());
  const std::uint32_t power = (word & 0xff800000U) + (word >> 4 & 3U) - 1U;
  return std::bit_cast<float>((word & 3U) == 0U ? power : word);
}

inline auto floats_in(float low, float high) {
  return [=](std::mt19937& random) { return std::uniform_real_distribution<float>(low, high)(random); };
}

/// True if a function of two gives each lane the bits that it gives the lane's floats alone; any NaN is as good.
template <int W, class Draw, class Function>
bool same_bits(Draw draw, Function function) {
  std::mt19937 random(static_cast<std::uint32_t>(W));
  for (int round = 0; round < 20'000; ++round) {
    std::array<float, W> a, b, found;
    for (std::size_t k = 0; k < W; ++k) {
      a[k] = draw(random);
      b[k] = draw(random);
    }
    function(lanes<W>::load(a.data()), lanes<W>::load(b.data())).store(found.data());
    for (std::size_t k = 0; k < W; ++k) {
      const float expected = function(a[k], b[k]);
      const bool same = std::bit_cast<std::uint32_t>(found[k]) == std::bit_cast<std::uint32_t>(expected);
      if (!same && !(std::isnan(found[k]) && std::isnan(expected))) return false;
    }
  }
  return true;
}

template <class Draw, class Function>
bool same_bits_at_every_width(Draw draw, Function function) {
  return same_bits<4>(draw, function) && same_bits<8>(draw, function) && same_bits<16>(draw, function);
}

template <int W>
using values = std::array<float, W>;

/// Of either sign and any magnitude, now and then 0, so that cases meet at random in one vector.
inline float any_value() {
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

/// -0 counts as 0: the sign of a zero is not part of the kernels' promise.
inline bool same_value(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace pelage::test
