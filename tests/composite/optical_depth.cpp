// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/optical_depth.hpp>
#include <pelage/core/lanes.hpp>

#include "composite/layers.hpp"
#include "property.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelage::test {

constexpr std::uint32_t unit = 1u << 20u;  // an octave
constexpr std::uint32_t most = 0xffffffffu;
constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

static_assert(optical_depth(0.5f) == unit && transmittance_of(2u * unit) == 0.25f && add_saturating(1u, most) == most);

TEST_CASE("an optical depth is -log2(1 - alpha) within half a unit and fast_log2's error") {
  worst_case worst;
  for (int i = 0; i < (1 << 24); i += 13) {
    const float alpha = static_cast<float>(i) * 0x1p-24f;
    const double octaves = -std::log2(1.0 - alpha);
    worst.see(std::abs(optical_depth(alpha) / 1048576.0 - octaves) - 1e-7 * std::max(1.0, octaves), {alpha});
  }
  CHECK_MESSAGE(worst.error <= 0x1p-21, worst);
}

TEST_CASE("alpha is clamped to [0, 1], NaN counts as 0, and an opaque fragment as 32 octaves") {
  for (const float none : {0.0f, -0.0f, -1.0f, -inf, nan}) {
    CHECK(optical_depth(none) == 0u);
  }
  for (const float opaque : {1.0f, 2.0f, inf}) {
    CHECK(optical_depth(opaque) == 32u * unit);
  }
  CHECK(optical_depth(std::nextafter(1.0f, 0.0f)) == 24u * unit);
}

TEST_CASE("to_fixed rounds to the nearest unit, ties up") {
  holds("as long double does", [] {
    const float x = std::ldexp(1.0f + draw_share(), *rc::gen::inRange(-30, 12));
    const float held = x < 4096.0f ? x : 4095.99f;
    RC_ASSERT(to_fixed(held) == static_cast<std::uint32_t>(std::floor(1048576.0L * held + 0.5L)));
  });
  CHECK(to_fixed(8.0f + 0x1p-20f) == 8u * unit + 1u);
}

TEST_CASE("to_fixed has an answer outside [0, 4096)") {
  for (const float none : {0.0f, -0.0f, -1.0f, -inf, nan}) {
    CHECK(to_fixed(none) == 0u);
  }
  CHECK(to_fixed(std::nextafter(4096.0f, 0.0f)) == most - 255u);
  for (const float all : {4096.0f, 1e30f, inf}) {
    CHECK(to_fixed(all) == most);
  }
}

TEST_CASE("add_saturating is the sum clamped to 32 bits") {
  holds("by the sum in 64 bits", [] {
    const auto draw = [] {
      return *rc::gen::oneOf(rc::gen::element(0u, 1u, most), rc::gen::arbitrary<std::uint32_t>());
    };
    const std::uint32_t a = draw();
    const std::uint32_t b = draw();
    RC_ASSERT(add_saturating(a, b) == std::min<std::uint64_t>(std::uint64_t{a} + b, most));
  });
}

TEST_CASE("the transmittance of a sum is 2 to minus its octaves within 1e-7 (1 + octaves / 2)") {
  worst_case worst;
  for (std::uint32_t optical = 0u; optical <= 126u * unit; optical += 97u) {
    const double octaves = optical / 1048576.0;
    worst.see(relative_error(transmittance_of(optical), std::exp2(-octaves)) / (1.0 + 0.5 * octaves), {octaves});
  }
  CHECK_MESSAGE(worst.error < 1e-7, worst);
}

template <class Number>
concept is_taken_as_optical = requires(Number x) {
  transmittance_of(x);
};
static_assert(is_taken_as_optical<std::uint32_t> && is_taken_as_optical<float>);
static_assert(!is_taken_as_optical<int> && !is_taken_as_optical<double> && !is_taken_as_optical<std::uint64_t>);

TEST_CASE("a float's transmittance is that of its integer, and falls to 0 beyond all integers") {
  holds("any amount", [] {
    const auto optical = *rc::gen::arbitrary<std::uint32_t>() >> *rc::gen::inRange(0, 32);
    RC_ASSERT(transmittance_of(static_cast<float>(optical)) == transmittance_of(optical));
  });
  for (const float beyond : {0x1p32f, 6.7e9f, 3e38f, std::numeric_limits<float>::infinity()}) {
    CHECK(transmittance_of(beyond) == 0.0f);
  }
  for (const float none : {-0.0f, -1.0f, -3e38f, std::numeric_limits<float>::quiet_NaN()}) {
    CHECK(transmittance_of(none) == 1.0f);
  }
}

TEST_CASE("nothing passes exactly all, and above 126 octaves all passes nothing") {
  CHECK(transmittance_of(0u) == 1.0f);
  CHECK(transmittance_of(126u * unit) == 0x1p-126f);
  for (const std::uint32_t optical : {126u * unit + 16u, 127u * unit, most}) {
    CHECK(transmittance_of(optical) == 0.0f);
  }
}

TEST_CASE("a sum of optical depths is the product of transmittances") {
  holds("within 3.4e-7 a fragment, and 1e-7 of its octaves", [] {
    std::uint32_t sum = 0u;
    double product = 1.0;
    double tolerance = 1e-7;
    for (const layer& each : draw_layers(0.9f)) {
      sum = add_saturating(sum, optical_depth(each.alpha));
      product *= 1.0 - each.alpha;
      tolerance += 3.4e-7 + 1e-7 * (1.0 - std::log2(1.0 - each.alpha));
    }
    RC_ASSERT(relative_error(transmittance_of(sum), product) < tolerance);
  });
}

/// Any bits, mostly of shares, now and then where a case begins.
float any_alpha() {
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
