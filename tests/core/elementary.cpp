// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/elementary.hpp>

#include <property.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

using namespace pelage;

namespace {

double relative(double found, double expected) {
  return std::abs(found - expected) / std::abs(expected);
}

}  // namespace

TEST_CASE("exponential is within 2e-7 from its least normal result to its greatest") {
  double worst = 0.0;
  for (int k = -870000; k < 883000; k += 7) {
    const float x = static_cast<float>(k) * 1e-4f;
    worst = std::max(worst, relative(exponential(x), std::exp(static_cast<double>(x))));
  }
  CHECK(worst < 2e-7);
}

TEST_CASE("exponential is 0 far below, infinite far above, exact at 0 and keeps NaN") {
  const float inf = std::numeric_limits<float>::infinity();
  CHECK(exponential(-88.5f) == 0.0f);
  CHECK(exponential(-inf) == 0.0f);
  CHECK(exponential(88.8f) == inf);
  CHECK(exponential(inf) == inf);
  CHECK(exponential(0.0f) == 1.0f);
  CHECK(std::isnan(exponential(std::numeric_limits<float>::quiet_NaN())));
}

TEST_CASE("one_minus_exponential keeps its relative precision down to the least arguments") {
  double worst = 0.0;
  for (double x = 1e-30; x < 50.0; x *= 1.0007) {
    const float rounded = static_cast<float>(x);
    worst = std::max(worst, relative(one_minus_exponential(rounded), -std::expm1(-static_cast<double>(rounded))));
  }
  CHECK(worst < 2e-7);
  CHECK(one_minus_exponential(0.0f) == 0.0f);
  CHECK(one_minus_exponential(std::numeric_limits<float>::infinity()) == 1.0f);
}

TEST_CASE("angles agree with atan2 all round the circle, whatever the length") {
  double worst = 0.0;
  for (int k = -31415; k <= 31415; ++k) {
    const double angle = k * 1e-4;
    for (const double length : {1e-12, 1.0, 3e9}) {
      const float y = static_cast<float>(length * std::sin(angle));
      const float x = static_cast<float>(length * std::cos(angle));
      const double expected = std::atan2(static_cast<double>(y), static_cast<double>(x));
      if (expected != 0.0) {
        worst = std::max(worst, relative(angle_of(y, x), expected));
        worst = std::max(worst, relative(unsigned_angle(y, x), std::abs(expected)));
      }
    }
  }
  CHECK(worst < 2e-7);
}

TEST_CASE("the angle of any vector is atan2's, however short, long or narrow it is, and that of NaN is NaN") {
  const auto any_float = [] {
    return std::bit_cast<float>(*rc::gen::oneOf(
        rc::gen::arbitrary<std::uint32_t>(),
        rc::gen::map(rc::gen::inRange(0u, 1u << 25u),
                     [](std::uint32_t w) { return (w & 0x00ffffffu) | w >> 24u << 31u; }),
        rc::gen::element(0u, 0x80000000u, 1u, 0x00800000u, 0x7f7fffffu, 0xff7fffffu, 0x7f800000u, 0x7fc00000u)));
  };
  test::holds("any bits", [&] {
    const float x = any_float();
    const float y = any_float();
    const double expected = std::abs(std::atan2(static_cast<double>(y), x + 0.0));
    RC_PRE(!(std::isinf(x) && std::isinf(y)));
    RC_LOG() << y << " " << x << " " << unsigned_angle(y, x) << " " << expected;
    if (std::isnan(expected)) {
      RC_ASSERT(std::isnan(unsigned_angle(y, x)) && std::isnan(angle_of(y, x)));
      RC_ASSERT(std::isnan(unsigned_angle<double>(y, x)) && std::isnan(angle_of<double>(y, x)));
    } else {
      RC_ASSERT(std::abs(unsigned_angle(y, x) - expected) <= 2e-7 * expected + 0x1p-149);
      RC_ASSERT(angle_of(y, x) == (y < 0.0f ? -unsigned_angle(y, x) : unsigned_angle(y, x)));
    }
    RC_ASSERT(std::isnan(angle_of_sine(y)) == std::isnan(y));
  });
}

TEST_CASE("the angle of no vector is 0") {
  CHECK(angle_of(0.0f, 0.0f) == 0.0f);
  CHECK(unsigned_angle(0.0f, 0.0f) == 0.0f);
  CHECK(unsigned_angle(0.0, 0.0) == 0.0);
}

TEST_CASE("angle_of_sine inverts the sine and holds what is no sine") {
  double worst = 0.0;
  for (int k = -9999; k <= 9999; ++k) {
    const float x = static_cast<float>(k) * 1e-4f;
    if (k != 0) {
      worst = std::max(worst, relative(angle_of_sine(x), std::asin(static_cast<double>(x))));
    }
  }
  CHECK(worst < 4e-7);
  CHECK(angle_of_sine(1.5f) == doctest::Approx(std::numbers::pi / 2).epsilon(1e-7));
  CHECK(angle_of_sine(-1.5f) == doctest::Approx(-std::numbers::pi / 2).epsilon(1e-7));
}

TEST_CASE("rotation_by is within 1.5e-7 of cosine and sine for |x| up to 100") {
  double worst = 0.0;
  for (int k = -100000; k <= 100000; ++k) {
    const float x = static_cast<float>(k) * 1e-3f;
    const rotation<float> r = rotation_by(x);
    worst = std::max(worst, std::abs(r.cosine - std::cos(static_cast<double>(x))));
    worst = std::max(worst, std::abs(r.sine - std::sin(static_cast<double>(x))));
  }
  CHECK(worst < 1.5e-7);
  CHECK(rotation_by(1e-20f).sine == doctest::Approx(1e-20).epsilon(1e-6));
  CHECK(std::isnan(rotation_by(std::numeric_limits<float>::infinity()).cosine));
}

TEST_CASE("rotations compose as angles add") {
  test::holds("turned_by adds angles, turned_back takes them away", [](std::int16_t a, std::int16_t b) {
    const double x = a * 1e-3;
    const double y = b * 1e-3;
    const rotation<double> sum = turned_by(rotation_by(x), rotation_by(y));
    const rotation<double> difference = turned_back(rotation_by(x), rotation_by(y));
    RC_ASSERT(std::abs(sum.sine - std::sin(x + y)) < 1e-13);
    RC_ASSERT(std::abs(difference.cosine - std::cos(x - y)) < 1e-13);
  });
}

TEST_CASE("natural_logarithm is within 1.4e-7 of the logarithm or of its size") {
  double worst = 0.0;
  for (double x = 1.2e-38; x < 3e38; x *= 1.003) {
    const float rounded = static_cast<float>(x);
    const double expected = std::log(static_cast<double>(rounded));
    worst = std::max(worst, std::abs(natural_logarithm(rounded) - expected) / std::max(1.0, std::abs(expected)));
  }
  for (float x = 2.5f; x < 3.0f; x = std::nextafter(x, 4.0f)) {  // the worst, 1.374e-7, is at 2.82428622
    const double expected = std::log(static_cast<double>(x));
    worst = std::max(worst, std::abs(natural_logarithm(x) - expected) / std::max(1.0, expected));
  }
  CHECK(worst < 1.4e-7);
  CHECK(natural_logarithm(1.0f) == 0.0f);
}
