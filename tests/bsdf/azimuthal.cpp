// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/azimuthal.hpp>
#include <pelage/bsdf/hair_parameters.hpp>

#include <property.hpp>
#include <sweep.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace pelage;

TEST_CASE("N integrates to 1 on the circle over the whole range of roughness") {
  for (const double beta : {0.01, 0.05, 0.3, 0.7, 1.0}) {
    const auto lobe = make_azimuthal_lobe(azimuthal_scale(static_cast<float>(beta)));
    const int count = 40000;
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {
      sum += static_cast<double>(evaluate_azimuthal(lobe, static_cast<float>(std::numbers::pi * (k + 0.5) / count)));
    }
    CAPTURE(beta);
    CHECK(2.0 * sum * std::numbers::pi / count == doctest::Approx(1.0).epsilon(1e-5));
  }
}

TEST_CASE("float's N has a relative error below 4e-7 (1 + x/s) for every scale") {
  test::worst_case worst;
  for (int i = 0; i < 200'000; ++i) {
    const auto [u, v] = test::even_point<2>(i);
    const auto lobe = make_azimuthal_lobe(static_cast<float>(test::on_log_scale(u, 1e-5, i % 2 == 0 ? 1e38 : 10.0)));
    const auto x = static_cast<float>(i % 3 == 0 ? test::on_log_scale(v, 1e-9, 1.0) : std::numbers::pi * v);
    const long double s = lobe.scale;
    const long double e = std::exp(-x / s);
    const long double exact = e / ((1 + e) * (1 + e) * s * std::tanh(std::numbers::pi_v<long double> / (2 * s)));
    if (x > 87 * s || exact < 1.2e-38L) continue;
    const auto error = static_cast<double>(std::abs(evaluate_azimuthal(lobe, x) / exact - 1));
    worst.see(error / static_cast<double>(1 + x / s), {lobe.scale, x});
  }
  CHECK_MESSAGE(worst.error < 4e-7, worst);
}

TEST_CASE("a wide lobe is nearly uniform and a narrow one a logistic") {
  const auto wide = make_azimuthal_lobe(100.0);
  CHECK(evaluate_azimuthal(wide, 3.0) == doctest::Approx(0.5 / std::numbers::pi).epsilon(1e-4));
  const auto narrow = make_azimuthal_lobe(0.1);
  CHECK(evaluate_azimuthal(narrow, 0.0) == doctest::Approx(2.5).epsilon(1e-12));
  CHECK(evaluate_azimuthal(narrow, 0.2) == doctest::Approx(10.0 / std::pow(2.0 * std::cosh(1.0), 2)).epsilon(1e-12));
}

TEST_CASE("the share of draws below a distance is N's integral to there") {
  for (const double scale : {0.02, 0.3, 4.0}) {
    const auto lobe = make_azimuthal_lobe(scale);
    // The trimmed logistic's own distribution function.
    const auto below = [&](double x) { return 1.0 / (1.0 + std::exp(-x / scale)); };
    const double pi = std::numbers::pi;
    for (int k = 0; k < 100; ++k) {
      const double u = (k + 0.5) / 100.0;
      const double x = sample_azimuthal(lobe, u);
      CHECK((below(x) - below(-pi)) / (below(pi) - below(-pi)) == doctest::Approx(u).epsilon(1e-9));
    }
  }
}

TEST_CASE("a band is the lobe averaged over a width, and the lobe itself where that is narrow") {
  for (const double scale : {0.01, 0.06, 0.3, 1.0, 4.0}) {
    const auto lobe = make_azimuthal_lobe(scale);
    for (const double extent : {0.0, 0.02, 0.3}) {
      CAPTURE(scale);
      CAPTURE(extent);
      const auto band = make_azimuthal_band(lobe, extent);
      const auto logistic = make_azimuthal_lobe(band.scale);
      const int count = 20000;
      double sum = 0.0;
      for (int k = 0; k < count; ++k)
        sum += 2.0 * evaluate_azimuthal(band, std::numbers::pi * (k + 0.5) / count) * std::numbers::pi / count;
      CHECK(sum == doctest::Approx(1.0).epsilon(1e-4));
      for (const double x : {0.0, 0.01, 0.1, 0.4, 2.0}) {
        double mean = 0.0;
        for (int k = 0; k < 1000; ++k)
          mean += 1e-3 * evaluate_azimuthal(logistic, std::abs(x + ((k + 0.5) * 1e-3 - 0.5) * band.width));
        const double is = evaluate_azimuthal(band, x);
        CHECK(is == doctest::Approx(mean).epsilon(1e-3));
        if (extent < 0.7 * scale) CHECK(is == doctest::Approx(evaluate_azimuthal(lobe, x)).epsilon(2e-3));
      }
      CHECK(band.width >= 0.7 * extent * (extent > 1.5 * scale ? 1.0 : 0.0));
    }
  }
}

TEST_CASE("a band of any extent loses less than 0.05 beyond the circle, one up to 0.4 less than 1e-4") {
  for (double scale = 0.01; scale < 6.0; scale *= 1.2) {
    for (const double extent : {0.1, 0.2, 0.3, 0.4, 0.8, 1.6, 2.4, 3.14}) {
      const auto band = make_azimuthal_band(make_azimuthal_lobe(scale), extent);
      const int count = 2000;
      double sum = 0.0;
      for (int k = 0; k < count; ++k)
        sum += 2.0 * evaluate_azimuthal(band, std::numbers::pi * (k + 0.5) / count) * std::numbers::pi / count;
      CAPTURE(scale);
      CAPTURE(extent);
      CHECK(sum < 1.0001);
      CHECK(sum > (extent <= 0.4 ? 0.9999 : 0.95));
    }
  }
}

TEST_CASE("draws stay on the circle at both ends and at roughness 0") {
  for (const float scale : {0.0f, 1e-4f, 0.05f, 4.0f, std::numeric_limits<float>::quiet_NaN()}) {
    const auto lobe = make_azimuthal_lobe(scale);
    for (const float u : {0.0f, 1e-7f, 0.5f, 0.99999994f}) {
      const float x = sample_azimuthal(lobe, u);
      CHECK(x >= -3.1415928f);
      CHECK(x <= 3.1415928f);
    }
    CHECK(std::isfinite(evaluate_azimuthal(lobe, 0.0f)));
    CHECK(std::isfinite(evaluate_azimuthal(lobe, 3.14159265f)));
  }
}
