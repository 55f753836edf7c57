// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_far_field.hpp>
#include <bsdf/sphere.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace pelage;

namespace {

chiang_fibre<double> fibre_of(double beta_n) {
  return make_chiang_fibre<double>({1.55, {0.1, 0.4, 1.5}, 0.3, beta_n, 0.035});
}

/// The average over the width by 8,000 midpoints of h itself.
double by_brute_force(const chiang_fibre<double>& fibre, double phi) {
  const int count = 8000;
  const auto eye = fibre_direction_of(test::unit_vector<double>(0.3, 0.0));
  const auto light = fibre_direction_of(test::unit_vector<double>(-0.25, phi));
  double sum = 0.0;
  for (int k = 0; k < count; ++k) {
    sum += evaluate_chiang(fibre, view_chiang(fibre, 2.0 * (k + 0.5) / count - 1.0, eye), light).value[1];
  }
  return sum / count;
}

template <int Panels>
double worst_error(double beta_n) {
  const auto fibre = fibre_of(beta_n);
  const auto eye = fibre_direction_of(test::unit_vector<double>(0.3, 0.0));
  double worst = 0.0;
  double greatest = 0.0;
  for (int k = 0; k < 24; ++k) {
    const double phi = k * std::numbers::pi / 23.0;
    const auto light = fibre_direction_of(test::unit_vector<double>(-0.25, phi));
    const double expected = by_brute_force(fibre, phi);
    worst = std::max(worst, std::abs(evaluate_chiang_far<Panels>(fibre, eye, light).value[1] - expected));
    greatest = std::max(greatest, expected);
  }
  return worst / greatest;
}

}  // namespace

TEST_CASE("the rule's error is as stated and falls as panels are added") {
  const double with_4 = worst_error<4>(0.3);
  const double with_8 = worst_error<8>(0.3);
  MESSAGE("relative to the peak: 4 panels ", with_4, ", 8 panels ", with_8, ", 16 at half the roughness ",
          worst_error<16>(0.15));
  CHECK(with_4 < 0.03);
  CHECK(with_8 < 0.004);
  CHECK(worst_error<16>(0.15) < 0.01);
  CHECK(worst_error<64>(0.3) < 2e-5);
}

TEST_CASE("the rule's weights are an average's") {
  double sum = 0.0;
  double mean = 0.0;
  double square = 0.0;
  for (int node = 0; node < 12; ++node) {
    const width_node<double> place = fibre_width_node<double>(node, 4);
    sum += place.weight;
    mean += place.weight * place.h;
    square += place.weight * place.h * place.h;
  }
  CHECK(sum == doctest::Approx(1.0).epsilon(1e-5));
  CHECK(std::abs(mean) < 1e-15);
  CHECK(square == doctest::Approx(1.0 / 3.0).epsilon(1e-4));
}

TEST_CASE("seen from afar a clear fibre still sends out all light") {
  const auto fibre = make_chiang_fibre<float>({1.55f, {0.0f, 0.0f, 0.0f}, 0.3f, 0.3f, 0.05f});
  const auto eye = fibre_direction_of(test::unit_vector<float>(0.8, 0.0));
  const double sum = test::integrate_sphere<float>(30, 60, [&](const glm::vec3& light) {
    return evaluate_chiang_far<4>(fibre, eye, fibre_direction_of(light)).value[2];
  });
  CHECK(sum == doctest::Approx(1.0).epsilon(2e-4));
}
