// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/bessel.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace pelage;

namespace {

/// ln I₀ by the integral (1/π) ∫ e^(x cos t) dt in long double: shares no step with the header.
long double log_i0_by_integral(long double x) {
  const int count = 1500;
  const long double pi = 3.141592653589793238462643383279502884L;
  // The trapezium rule on a period converges faster than any power; e^(x (cos t - 1)) cannot overflow. The variable is
  // stretched where x is large, since the peak has the width 1/√x.
  if (x > 400.0L) {
    const long double end = 12.0L / std::sqrt(x);
    long double sum = 0.5L;
    for (int k = 1; k <= count; ++k) {
      const long double half = std::sin(0.5L * end * static_cast<long double>(k) / count);
      sum += std::exp(-2.0L * x * half * half);
    }
    return x + std::log(sum * end / count / pi);
  }
  long double sum = 0.5L * (1.0L + std::exp(-2.0L * x));
  for (int k = 1; k < count; ++k) {
    const long double half = std::sin(0.5L * pi * static_cast<long double>(k) / count);
    sum += std::exp(-2.0L * x * half * half);
  }
  return x + std::log(sum / count);
}

template <class Real>
long double worst_error(long double low, long double high) {
  long double worst = 0.0L;
  for (long double x = low; x < high; x *= 1.05L) {
    const Real rounded = static_cast<Real>(x);
    const long double expected = log_i0_by_integral(rounded);
    worst = std::max(worst, std::abs(static_cast<long double>(log_bessel_i0(rounded)) - expected) / expected);
  }
  return worst;
}

}  // namespace

TEST_CASE("log I0 has float's full precision from 0.01 to a million") {
  CHECK(worst_error<float>(0.01L, 5.9L) < 1e-6L);
  CHECK(worst_error<float>(5.9L, 13.0L) < 1e-6L);
  CHECK(worst_error<float>(13.0L, 1e6L) < 1e-6L);
}

TEST_CASE("log I0 has double's precision from 0.3 to a million") {
  CHECK(worst_error<double>(0.3L, 19.9L) < 1e-14L);
  CHECK(worst_error<double>(19.9L, 1e6L) < 1e-14L);
}

TEST_CASE("log I0 is x²/4 near 0, where the logarithm of a sum has lost everything") {
  for (const float x : {1e-18f, 1e-10f, 1e-4f, 3e-3f}) {
    CHECK(static_cast<double>(log_bessel_i0(x)) == doctest::Approx(0.25 * static_cast<double>(x) * x).epsilon(3e-6));
  }
  CHECK(log_bessel_i0(1e-8) == doctest::Approx(2.5e-17).epsilon(1e-12));
  CHECK(log_bessel_i0(0.0f) == 0.0f);
  CHECK(log_bessel_i0(0.0) == 0.0);
}

TEST_CASE("log I0 at 12 is ln 18948.925, of which the series truncated to ten terms lacks 2 %") {
  CHECK(log_bessel_i0(12.0) == doctest::Approx(std::log(18948.925346)).epsilon(1e-10));
  CHECK(static_cast<double>(log_bessel_i0(12.0f)) == doctest::Approx(log_bessel_i0(12.0)).epsilon(1e-6));
}

TEST_CASE("value and growth together are I0 on either side of where the form changes") {
  for (const float x : {5.999f, 6.0f, 6.001f}) {
    const bessel_i0_parts<float> parts = bessel_i0(x);
    const double found = std::log(static_cast<double>(parts.value)) + static_cast<double>(parts.growth);
    CHECK(found == doctest::Approx(static_cast<double>(log_i0_by_integral(x))).epsilon(1e-7));
  }
  CHECK(bessel_i0(0.0f).value == 1.0f);
}
