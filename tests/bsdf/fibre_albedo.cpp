// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/fibre_albedo.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>

#include <cmath>
#include <limits>

using namespace pelage;

TEST_CASE("a fibre's albedo is the integral of its BSDF over all directions and its width") {
  for (const double sigma : {0.0, 0.2, 3.0}) {
    const auto fibre = make_chiang_fibre<double>({1.55, {sigma, sigma, sigma}, 0.5, 0.5, 0.03});
    for (const double theta : {0.0, -0.8}) {
      const auto eye = fibre_direction_of(test::unit_vector<double>(theta, 0.3));
      const double scattered = test::integrate(-1.0, 1.0, 20, [&](double h) {
        const auto view = view_chiang(fibre, h, eye);
        return 0.5 * test::integrate_sphere<double>(12, 32, [&](const glm::dvec3& light) {
                 return evaluate_chiang(fibre, view, fibre_direction_of(light)).value.x;
               });
      });
      CHECK(fibre_albedo(1.55, sigma, std::sin(theta)) == doctest::Approx(scattered).epsilon(1e-3));
    }
  }
}

TEST_CASE("a fibre's albedo is within 1e-3 of brute force over the width, whatever the fibre") {
  test::holds("brute force", [](std::uint8_t index, std::uint16_t dark, std::int8_t slope) {
    const double eta = 1.0 + index / 127.5;
    const double sigma = std::pow(dark / 4096.0, 3.0);
    const double sine = slope / 128.5;
    double sum = 0.0;
    for (int i = 0; i < 2000; ++i) {
      const double h = -1.0 + (i + 0.5) / 1000.0;
      const auto section = detail::cross_chiang_section(eta, h, sine, std::sqrt(1.0 - sine * sine));
      const double kept = std::exp(-sigma * section.radii);
      const double f = section.surface.reflected;
      sum += (f + (1.0 - f) * (1.0 - f) * kept / (f * kept < 1.0 ? 1.0 - f * kept : 1.0)) / 2000.0;
    }
    RC_ASSERT(std::abs(fibre_albedo(eta, sigma, sine) - sum) < 1e-3);
  });
}

TEST_CASE("absorption_from_fibre_albedo is the inverse, and defined beyond its range") {
  for (int k = 80; k <= 1000; ++k) {
    const double colour = 0.001 * k;
    CHECK(std::abs(fibre_albedo(1.55, absorption_from_fibre_albedo(colour, 1.55), 0.0) - colour) < 1e-6);
    const auto narrow = static_cast<float>(colour);
    CHECK(std::abs(fibre_albedo(1.55f, absorption_from_fibre_albedo(narrow, 1.55f), 0.0f) - narrow) < 1e-6f);
  }
  CHECK(absorption_from_fibre_albedo(1.0, 1.55) == 0.0);
  CHECK(absorption_from_fibre_albedo(2.0, 1.55) == 0.0);
  CHECK(absorption_from_fibre_albedo(0.05, 1.55) > 28.0);
  CHECK(absorption_from_fibre_albedo(std::numeric_limits<double>::quiet_NaN(), 1.55) < 28.5);
  CHECK(fibre_albedo(1.55, 0.0, 1.0) == doctest::Approx(1.0));
  CHECK(fibre_albedo(1.55, std::numeric_limits<double>::infinity(), 0.0) == doctest::Approx(0.075).epsilon(1e-3));
  CHECK(fibre_albedo(1.55, std::numeric_limits<double>::quiet_NaN(), 0.0) == fibre_albedo(1.55, 1e30, 0.0));
  CHECK(fibre_albedo(1.55, absorption_from_albedo(0.1, 0.3), 0.0) == doctest::Approx(0.76).epsilon(3e-3));
}

TEST_CASE("no fibre scatters more than it meets, and colours from 1 on need none of its absorption") {
  test::holds("in floats", [](std::uint8_t index, std::int8_t slope) {
    const float eta = 1.0f + static_cast<float>(index) / 127.5f;
    RC_ASSERT(fibre_albedo(eta, 0.0f, static_cast<float>(slope) / 128.0f) <= 1.0f);
    RC_ASSERT(absorption_from_fibre_albedo(1.0f, eta) == 0.0f);
  });
  CHECK(absorption_from_fibre_albedo(1.0f, 1.0f) == 0.0f);
}
