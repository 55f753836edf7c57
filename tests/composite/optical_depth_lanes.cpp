// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/optical_depth.hpp>
#include <pelage/core/lanes.hpp>

#include "property.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace pelage::test {

/// Any bits, mostly of shares, now and then where a case begins.
float any_alpha() {
  constexpr float inf = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      return std::bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>());
    case 1:
      return *rc::gen::element(0.0f, -0.0f, 1.0f, 0x1.fffffep-1f, 0x1p-149f, 8.0f, 4095.9998f, 4096.0f, inf, -inf, nan);
    default:
      return static_cast<float>(*rc::gen::inRange(0, 1 << 24)) * 0x1p-24f;
  }
}

template <int W>
void check_lanes() {
  std::array<float, W> x;
  std::array<std::uint32_t, W> a, b;
  for (float& one : x)
    one = any_alpha();
  for (std::size_t k = 0; k < W; ++k) {
    a[k] = *rc::gen::arbitrary<std::uint32_t>();
    b[k] = *rc::gen::arbitrary<bool>() ? 0xffffffffu - a[k] + *rc::gen::inRange(0u, 3u) - 1u : a[k] / 3u;
  }
  const auto packed = [](const auto& words) {
    return lanes<W, std::uint32_t>{std::bit_cast<typename lanes<W>::naturals>(words)};
  };
  const lanes<W, std::uint32_t> optical = optical_depth(lanes<W>::load(x.data()));
  const lanes<W, std::uint32_t> fixed = to_fixed(lanes<W>::load(x.data()));
  const lanes<W, std::uint32_t> sum = add_saturating(packed(a), packed(b));
  std::uint32_t all = 0u;
  for (std::size_t k = 0; k < W; ++k) {
    RC_LOG() << x[k] << " " << a[k] << " " << b[k];
    RC_ASSERT(optical.lane[k] == optical_depth(x[k]));
    RC_ASSERT(fixed.lane[k] == to_fixed(x[k]));
    RC_ASSERT(sum.lane[k] == add_saturating(a[k], b[k]));
    all = add_saturating(all, b[k]);
  }
  RC_ASSERT(sum_saturating(packed(b)) == all);
}

TEST_CASE("optical depths, fixed-point numbers and sums of lanes are the scalar ones, bit for bit") {
  holds("4 lanes", check_lanes<4>);
  holds("8 lanes", check_lanes<8>);
  holds("16 lanes", check_lanes<16>);
}

}  // namespace pelage::test
