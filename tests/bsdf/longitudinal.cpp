// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/hair_parameters.hpp>
#include <pelage/bsdf/longitudinal.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>
#include <sweep.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace pelage;

namespace {

/// ∫ M cos θ_i dθ_i.
template <class Real>
double integral(const longitudinal_lobe<Real>& lobe, double theta_o) {
  const int panels = static_cast<int>(2.0 / std::min(std::sqrt(static_cast<double>(lobe.variance)), 0.1)) + 1;
  return test::integrate(-0.5 * std::numbers::pi, 0.5 * std::numbers::pi, panels, [&](double theta) {
    return std::cos(theta) * static_cast<double>(evaluate_longitudinal(
                                 lobe, static_cast<Real>(std::sin(theta)), static_cast<Real>(std::cos(theta)),
                                 static_cast<Real>(std::sin(theta_o)), static_cast<Real>(std::cos(theta_o))));
  });
}

/// ln M as the paper writes it, with I₀ by its integral in long double.
long double log_m(long double theta_i, long double theta_o, long double v) {
  const long double a = std::cos(theta_i) * std::cos(theta_o) / v;
  long double i0 = 0.0L;
  const int count = 20000;
  for (int k = 0; k < count; ++k) {
    const long double t = std::numbers::pi_v<long double> * (static_cast<long double>(k) + 0.5L) / count;
    i0 += std::exp(a * (std::cos(t) - 1.0L));
  }
  return std::log(i0 / count) + a - std::sin(theta_i) * std::sin(theta_o) / v - 1.0L / v -
         std::log(v * (1.0L - std::exp(-2.0L / v)));
}

}  // namespace

TEST_CASE("M integrates to 1 over the whole range of roughness, at every inclination") {
  for (const double beta : {0.01, 0.05, 0.2, 0.5, 1.0}) {
    for (const double theta : {-1.5, -0.8, 0.0, 0.4, 1.2, 1.57}) {
      CAPTURE(beta);
      CAPTURE(theta);
      CHECK(integral(make_longitudinal_lobe(longitudinal_variance(beta)), theta) == doctest::Approx(1.0).epsilon(1e-5));
      // At 1.57 the nearest float to the sine is another angle.
      if (theta < 1.55) {
        const auto narrow = make_longitudinal_lobe(longitudinal_variance(static_cast<float>(beta)));
        CHECK(integral(narrow, theta) == doctest::Approx(1.0).epsilon(3e-5));
      }
    }
  }
}

TEST_CASE("float's M has a relative error below 1e-6 (1 + gap/v) for every variance") {
  test::worst_case worst;
  for (int i = 0; i < 30'000; ++i) {
    const auto [a, b, c] = test::even_point<3>(i);
    const auto lobe = make_longitudinal_lobe(static_cast<float>(test::on_log_scale(a, 1e-8, i % 2 == 0 ? 1e38 : 10.0)));
    const auto gap = static_cast<float>(i % 3 == 0 ? 2.0 * b : test::on_log_scale(b, 1e-12, 2.0));
    const auto product = static_cast<float>(i % 5 == 0 ? test::on_log_scale(c, 1e-30, 1.0) : c);
    const long double v = lobe.variance;
    const long double x = product / v;
    // e⁻ˣ I₀(x) as the mean of e^(x (cos t - 1)) by the trapezium rule, which is exact to long double here.
    long double mean = 0.0L;
    const int count = x > 400.0L ? 0 : 200;
    for (int k = 0; k < count; ++k)
      mean += std::exp(x * (std::cos(std::numbers::pi_v<long double> * (k + 0.5L) / count) - 1.0L)) / count;
    if (count == 0) mean = (1 + 0.125L / x + 0.0703125L / (x * x)) / std::sqrt(2 * std::numbers::pi_v<long double> * x);
    const long double exact = std::exp(-gap / v) * mean / (v * -std::expm1(-2 / v));
    if (gap > 81 * v || exact < 1.2e-38L) continue;
    const auto error = static_cast<double>(std::abs(evaluate_longitudinal(lobe, {gap, product}) / exact - 1));
    worst.see(error / static_cast<double>(1 + gap / v), {lobe.variance, gap, product});
  }
  CHECK_MESSAGE(worst.error < 1e-6, worst);
}

TEST_CASE("float's M is within 2e-5 at β_m 0.01, where logarithms that cancel lose a hundredth") {
  const float v = longitudinal_variance(0.01f);
  double worst = 0.0;
  for (const float theta_o : {0.0f, 0.3f, -1.0f, 1.4f}) {
    for (const float off : {0.0f, 0.003f, -0.01f, 0.02f}) {
      const float theta_i = -theta_o + off;
      const float sin_i = std::sin(theta_i);
      const float sin_o = std::sin(theta_o);
      const auto cosine = [](float s) { return std::sqrt((1.0f - s) * (1.0f + s)); };
      const float found = evaluate_longitudinal(make_longitudinal_lobe(v), sin_i, cosine(sin_i), sin_o, cosine(sin_o));
      const long double expected =
          std::exp(log_m(std::asin(static_cast<long double>(sin_i)), std::asin(static_cast<long double>(sin_o)), v));
      worst = std::max(worst, static_cast<double>(std::abs(found / expected - 1.0L)));
    }
  }
  CHECK(worst < 2e-5);
}

TEST_CASE("M is symmetric in its inclinations") {
  test::holds("M(a, b) = M(b, a)", [](std::int8_t a, std::int8_t b, std::uint8_t rough) {
    const double x = a / 128.0 * 1.55;
    const double y = b / 128.0 * 1.55;
    const auto lobe = make_longitudinal_lobe(longitudinal_variance((rough + 1) / 256.0));
    const double one = evaluate_longitudinal(lobe, std::sin(x), std::cos(x), std::sin(y), std::cos(y));
    const double other = evaluate_longitudinal(lobe, std::sin(y), std::cos(y), std::sin(x), std::cos(x));
    RC_ASSERT(std::abs(one - other) <= 1e-9 * one);
  });
}

TEST_CASE("a roughness of 0 or NaN is a narrow lobe and finite") {
  for (const float v : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    const auto lobe = make_longitudinal_lobe(v);
    CHECK(std::isfinite(evaluate_longitudinal(lobe, 0.5f, std::sqrt(0.75f), -0.5f, std::sqrt(0.75f))));
    CHECK(evaluate_longitudinal(lobe, 0.5f, std::sqrt(0.75f), 0.5f, std::sqrt(0.75f)) == 0.0f);
  }
}

TEST_CASE("sine_of_sum keeps the digits of nearly opposite angles") {
  const float a = 0.7f;
  const float b = std::nextafter(-0.7f, -1.0f);
  const double wide_a = a;
  const double wide_b = b;
  const double expected = std::sin(std::asin(wide_a) + std::asin(wide_b));
  const float found = sine_of_sum(a, std::sqrt(1.0f - a * a), b, std::sqrt(1.0f - b * b));
  CHECK(static_cast<double>(found) == doctest::Approx(expected).epsilon(1e-5));
  CHECK(sine_of_sum(0.0f, 1.0f, 0.0f, 1.0f) == 0.0f);
}

TEST_CASE("versine keeps the digits of small angles and reaches 2") {
  CHECK(static_cast<double>(versine(rotation_by(1e-5f))) == doctest::Approx(5e-11).epsilon(1e-5));
  CHECK(versine(rotation<float>{-1.0f, 0.0f}) == 2.0f);
}

TEST_CASE("drawn inclinations are unit vectors with M's mean sine") {
  for (const float v : {1e-7f, 1e-3f, 0.1f, 5.0f, 100.0f}) {
    const auto lobe = make_longitudinal_lobe(v);
    const float sin_o = 0.6f;
    double mean = 0.0;
    const int count = 10000;
    for (int k = 0; k < count; ++k) {
      const float u = static_cast<float>(k) / count;
      const float turn = static_cast<float>(std::fmod(k * 0.6180339887498949, 1.0));
      const rotation<float> drawn = sample_longitudinal(lobe, sin_o, 0.8f, u, turn);
      REQUIRE(std::abs(drawn.cosine * drawn.cosine + drawn.sine * drawn.sine - 1.0f) < 4e-7f);
      REQUIRE(drawn.cosine >= 0.0f);
      mean += static_cast<double>(drawn.sine) / count;
    }
    // The mean of the distribution on the sphere is coth(1/v) - v of its axis.
    const double wide = v;
    CHECK(mean == doctest::Approx(-0.6 * (1.0 / std::tanh(1.0 / wide) - wide)).epsilon(0.01));
  }
}
