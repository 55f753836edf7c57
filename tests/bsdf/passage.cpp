// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/passage.hpp>
#include <bsdf/sphere.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace pelage;

TEST_CASE("what passes a fibre is the integral of the BSDF's TT lobe over all directions") {
  const std::array<double, 3> sigma = {0.05, 0.5, 2.0};
  auto fibre = make_chiang_fibre<double>({1.55, sigma, 0.4, 0.4, 0.05});
  fibre.tints = {0.0, 1.0, 0.0, 0.0};
  for (const double theta : {0.0, 0.7, -1.3}) {
    const auto eye = direction_by_fibre(test::unit_vector<double>(theta, 0.0));
    const std::array<double, 3> passage = mean_passage<4>(1.55, sigma, std::sin(theta));
    for (std::uint32_t c = 0; c < 3; ++c) {
      const double lobe = test::integrate_sphere<double>(40, 48, [&](const glm::dvec3& light) {
        return evaluate_chiang_far<4>(fibre, eye, direction_by_fibre(light)).value[c];
      });
      CHECK(passage[c] == doctest::Approx(lobe).epsilon(1e-4));
    }
  }
}

TEST_CASE("through the axis a clear fibre passes fibre_attenuation()") {
  for (const double sine : {-0.9, 0.0, 0.3, 1.0}) {
    CHECK(axial_passage<double>(1.55, {0.0, 1.0, 2.0}, sine)[0] ==
          doctest::Approx(fibre_attenuation(1.55, sine)).epsilon(1e-12));
  }
}

TEST_CASE("four panels are within 1e-3 of many, two within 4e-3, and more absorption passes less") {
  double last = 1.0;
  for (const double sigma : {0.0, 0.3, 1.0, 3.0}) {
    const double two = mean_passage<2>(1.55, std::array<double, 3>{sigma, sigma, sigma}, 0.4)[0];
    const double many = mean_passage<64>(1.55, std::array<double, 3>{sigma, sigma, sigma}, 0.4)[0];
    const double four = mean_passage<4>(1.55, std::array<double, 3>{sigma, sigma, sigma}, 0.4)[0];
    CHECK(std::abs(two - many) < 4e-3);
    CHECK(std::abs(four - many) < 1e-3);
    CHECK(many < last);
    last = many;
  }
}
