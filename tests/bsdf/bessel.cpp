// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/bessel.hpp>

#include <property.hpp>
#include <sweep.hpp>

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

namespace {

/// I₀ - 1 for x < 60 and e⁻ˣ I₀ from 60 on, by their series in long double.
long double i0_rise(long double x) {
  long double term = 1.0L, sum = 0.0L;
  for (int k = 1; k < 300; ++k)
    sum += term *= 0.25L * x * x / (static_cast<long double>(k) * k);
  return sum;
}
long double i0_far(long double x) {
  long double term = 1.0L, sum = 1.0L;
  for (int k = 1; k < 30; ++k)
    sum += term *= static_cast<long double>((2 * k - 1) * (2 * k - 1)) / (8 * k * x);
  return sum / std::sqrt(6.283185307179586476925286766559L * x);
}

/// The worst relative errors of the value and of ln I₀ for arguments from `low` to `high`.
template <class Real>
void check_range(double low, double high, double of_value, double of_logarithm) {
  pelage::test::worst_case value, logarithm;
  for (int i = 0; i < 60'000; ++i) {
    const auto x = static_cast<Real>(pelage::test::on_log_scale(pelage::test::even_point<1>(i)[0], low, high));
    const bool far = x >= Real(60);
    const long double whole = far ? i0_far(x) : 1.0L + i0_rise(x);
    const bessel_i0_parts<Real> parts = bessel_i0(x);
    const long double expected =
        far || parts.growth == Real(0) ? whole : whole * std::exp(-static_cast<long double>(x));
    value.see(static_cast<double>(std::abs(parts.value / expected - 1)), {static_cast<double>(x)});
    const long double ln = far ? x + std::log(whole) : std::log1p(i0_rise(x));
    logarithm.see(static_cast<double>(std::abs(log_bessel_i0(x) / ln - 1)), {static_cast<double>(x)});
  }
  CHECK_MESSAGE(value.error < of_value, value);
  CHECK_MESSAGE(logarithm.error < of_logarithm, logarithm);
}

}  // namespace

TEST_CASE("I0 and its logarithm keep their digits from the least argument to the greatest") {
  check_range<float>(3e-19, 1.0, 3e-7, 1e-6);
  check_range<float>(1.0, 100.0, 3e-7, 1e-6);
  check_range<float>(100.0, 3e38, 3e-7, 1e-6);
  check_range<double>(1e-150, 1.0, 3e-15, 1e-14);
  check_range<double>(1.0, 100.0, 3e-15, 1e-14);
  check_range<double>(15.0, 22.0, 3e-15, 1e-14);
  check_range<double>(100.0, 1e300, 3e-15, 1e-14);
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
