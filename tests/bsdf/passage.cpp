// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/passage.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>
#include <sweep.hpp>

#include <array>
#include <cmath>

using namespace pelage;

TEST_CASE("what passes a fibre is the integral of the BSDF's TT lobe over all directions") {
  const std::array<double, 3> sigma = {0.05, 0.5, 2.0};
  auto fibre = make_chiang_fibre<double>({1.55, sigma, 0.4, 0.4, 0.05});
  fibre.tints = {0.0, 1.0, 0.0, 0.0};
  for (const double theta : {0.0, 0.7, -1.3}) {
    const auto eye = fibre_direction_of(test::unit_vector<double>(theta, 0.0));
    const glm::dvec3 passage = mean_passage<4>(1.55, sigma, std::sin(theta));
    for (int c = 0; c < 3; ++c) {
      const double lobe = test::integrate_sphere<double>(40, 48, [&](const glm::dvec3& light) {
        double sum = 0.0;
        for (int node = 0; node < 12; ++node) {
          const auto place = fibre_width_node<double>(node, 4);
          const auto view = view_chiang(fibre, place.h, eye);
          sum += place.weight * evaluate_chiang(fibre, view, fibre_direction_of(light)).value[c];
        }
        return sum;
      });
      CHECK(passage[c] == doctest::Approx(lobe).epsilon(1e-4));
    }
  }
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

TEST_CASE("through the axis a clear fibre passes fibre_attenuation()") {
  for (const double sine : {-0.9, 0.0, 0.3, 1.0}) {
    CHECK(axial_passage<double>(1.55, {0.0, 1.0, 2.0}, sine)[0] ==
          doctest::Approx(fibre_attenuation(1.55, sine)).epsilon(1e-12));
  }
}

TEST_CASE("two panels are within 7.5e-3 of many, four within 2e-3, eight within 5e-4, whatever the fibre") {
  test::worst_case two, four, eight;
  const auto see = [&](double eta, double sigma, double sine) {
    const std::array<double, 3> one = {sigma, sigma, sigma};
    const double many = mean_passage<64>(eta, one, sine)[0];
    two.see(std::abs(mean_passage<2>(eta, one, sine)[0] - many), {eta, sigma, sine});
    four.see(std::abs(mean_passage<4>(eta, one, sine)[0] - many), {eta, sigma, sine});
    eight.see(std::abs(mean_passage<8>(eta, one, sine)[0] - many), {eta, sigma, sine});
  };
  see(1.15291, 0.0, 0.028);
  for (int i = 0; i < 6000; ++i) {
    const auto [u, v, w] = test::even_point<3>(i);
    const double eta = i % 2 == 0 ? 1.0 + 0.3 * u : 1.0 + 2.0 * u;
    const double sigma = i % 3 == 0 ? 0.0 : test::on_log_scale(v, 1e-3, 1e3);
    see(eta, sigma, i % 5 == 0 ? 1.0 - test::on_log_scale(w, 1e-6, 1.0) : 2.0 * w - 1.0);
  }
  CHECK_MESSAGE(two.error < 7.5e-3, two);
  CHECK_MESSAGE(four.error < 2e-3, four);
  CHECK_MESSAGE(eight.error < 5e-4, eight);
}

TEST_CASE("more absorption passes less") {
  double last = 1.0;
  for (const double sigma : {0.0, 0.3, 1.0, 3.0}) {
    const double passed = mean_passage<4>(1.55, std::array<double, 3>{sigma, sigma, sigma}, 0.4)[0];
    CHECK(passed < last);
    last = passed;
  }
}
