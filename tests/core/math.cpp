// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/math.hpp>

#include "lane_bits.hpp"
#include "property.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float denormal = std::numeric_limits<float>::denorm_min();
constexpr float least_normal = std::numeric_limits<float>::min();

static_assert(sqr(3.0f) == 9.0f && saturate(2.0) == 1.0);
static_assert(fast_log2(8.0f) == 3.0f && fast_exp2(-3.0f) == 0.125f && power_of_cosine(0.5f, 2.0f) == 0.25f);

double log2_error(float x) {
  const double exact = std::log2(static_cast<double>(x));
  return std::abs(fast_log2(x) - exact) / std::max(1.0, std::abs(exact));
}

TEST_CASE("fast_log2 is within 1e-7 for every float in [½, 2) and 100,000 beyond") {
  worst_case worst;
  for (std::uint32_t bits = 0x3f000000u; bits < 0x40000000u; ++bits) {
    worst.see(log2_error(std::bit_cast<float>(bits)), {std::bit_cast<float>(bits)});
  }
  for (std::uint32_t bits = 0x00800000u; bits < 0x7f800000u; bits += 21247u) {
    worst.see(log2_error(std::bit_cast<float>(bits)), {std::bit_cast<float>(bits)});
  }
  CHECK_MESSAGE(worst.error < 1e-7, worst);
}

TEST_CASE("fast_exp2 is within 1e-7 relative over its range") {
  worst_case worst;
  for (int i = 0; i < 254 * 8192; ++i) {
    const float x = -126.0f + static_cast<float>(i) * 0x1p-13f;
    worst.see(relative_error(fast_exp2(x), std::exp2(static_cast<double>(x))), {x});
  }
  for (std::uint32_t bits = 0u; bits < 0x3f800000u; bits += 4099u) {
    const float small = std::bit_cast<float>(bits);
    worst.see(relative_error(fast_exp2(small), std::exp2(static_cast<double>(small))), {small});
    worst.see(relative_error(fast_exp2(-small), std::exp2(-static_cast<double>(small))), {-small});
  }
  CHECK_MESSAGE(worst.error < 1e-7, worst);
}

TEST_CASE("logarithm and power are exact at powers of two") {
  for (int exponent = -126; exponent < 128; ++exponent) {
    const float power = std::ldexp(1.0f, exponent);
    CHECK(fast_log2(power) == static_cast<float>(exponent));
    CHECK(fast_exp2(static_cast<float>(exponent)) == power);
  }
}

TEST_CASE("fast_log2 has an answer outside the normal numbers") {
  for (const float x : {0.0f, -0.0f, denormal, std::nextafter(least_normal, 0.0f), -denormal, -1.0f, -inf}) {
    CHECK(fast_log2(x) == -126.0f);
  }
  CHECK(fast_log2(inf) == 128.0f);
  CHECK(std::isnan(fast_log2(nan)));
}

TEST_CASE("fast_exp2 has an answer outside [-126, 128)") {
  for (const float x : {std::nextafter(-126.0f, -inf), -127.0f, -1e30f, -inf}) {
    CHECK(fast_exp2(x) == 0.0f);
  }
  CHECK(std::isfinite(fast_exp2(std::nextafter(128.0f, 0.0f))));
  for (const float x : {128.0f, 1e30f, inf}) {
    CHECK(fast_exp2(x) == inf);
  }
  CHECK(std::isnan(fast_exp2(nan)));
}

TEST_CASE("power_of_cosine is within 2e-7 (1 + y |log2 x|) where the result is normal, else 0") {
  worst_case worst;
  bool zero_or_normal = true;
  for (int i = 0; i < 1'000'000; ++i) {
    const auto [u, v, end] = even_point<3>(i);
    const double near_one = 1.0 - on_log_scale(u, 1e-7, 1.0);
    const double near_zero = on_log_scale(u, 1e-37, 1.0);
    const float x = static_cast<float>(end < 0.5 ? near_one : near_zero);
    const float y = static_cast<float>(on_log_scale(v, 1e-6, 1e6));
    const float power = power_of_cosine(x, y);
    zero_or_normal = zero_or_normal && (power == 0.0f || std::isnormal(power));
    const double octaves = y * std::log2(static_cast<double>(x));
    if (octaves > -125.99) {
      worst.see(relative_error(power, std::exp2(octaves)) / (1.0 - octaves), {x, y});
    } else if (octaves < -126.01) {
      worst.see(power, {x, y});
    }
  }
  CHECK(zero_or_normal);
  CHECK_MESSAGE(worst.error < 2e-7, worst);
}

TEST_CASE("power_of_cosine counts a base without a logarithm as 0, and 0 to the power of 0 as 1") {
  for (const float base : {0.0f, -0.0f, denormal, -0.5f, -inf, nan}) {
    CHECK(power_of_cosine(base, 2.0f) == 0.0f);
    CHECK(power_of_cosine(base, 1e-3f) == 0.0f);
    CHECK(power_of_cosine(base, 0.0f) == 1.0f);
    CHECK(power_of_cosine(base, denormal) == 1.0f);
  }
  CHECK(power_of_cosine(1.0f, 1e30f) == 1.0f);
}

TEST_CASE("safe_sqrt is the root, and 0 where there is none") {
  constexpr float least = std::numeric_limits<float>::min();
  holds("the root of what has one", [](float x) { RC_ASSERT(safe_sqrt(x) == (x >= least ? std::sqrt(x) : 0.0f)); });
  CHECK(safe_sqrt(least) == std::sqrt(least));
  CHECK(safe_sqrt(0.5f * least) == 0.0f);
  CHECK(safe_sqrt(nan) == 0.0f);
  CHECK(safe_sqrt(inf) == inf);
}

TEST_CASE("saturate holds to [0, 1]") {
  holds("as std::clamp", [](float x) { RC_ASSERT(saturate(x) == std::clamp(x, 0.0f, 1.0f)); });
  CHECK(saturate(nan) == 0.0f);
  CHECK(saturate(-inf) == 0.0f);
  CHECK(saturate(inf) == 1.0f);
}

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

}  // namespace pelage::test
