// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/fresnel.hpp>

#include "bsdf/surfaces.hpp"
#include "property.hpp"
#include "sweep.hpp"

#include <cmath>
#include <limits>

namespace pelage::test {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

TEST_CASE("reflectance into the denser medium is that of the angles within 1e-6 relative") {
  worst_case worst;
  for_each_surface(1.5, 1000.0, [&](float cosine, float eta) {
    worst.see(relative_error(fresnel_dielectric(cosine, eta), fresnel_by_angles(cosine, eta).reflected), {cosine, eta});
  });
  CHECK_MESSAGE(worst.error < 1e-6, worst);
}

TEST_CASE("reflectance into the thinner medium is that of the angles within 5e-4, down to an index of 0.3") {
  worst_case worst;
  for_each_surface(0.3, 0.7, [&](float cosine, float eta) {
    worst.see(std::abs(fresnel_dielectric(cosine, eta) - fresnel_by_angles(cosine, eta).reflected), {cosine, eta});
  });
  CHECK_MESSAGE(worst.error < 5e-4, worst);
}

TEST_CASE("in double both are, within 1e-13 relative and 1e-7") {
  worst_case denser;
  worst_case thinner;
  for_each_surface(0.3, 1000.0, [&](double cosine, double eta) {
    const double error = fresnel_dielectric(cosine, eta) - fresnel_by_angles(cosine, eta).reflected;
    if (eta >= 1.0) {
      denser.see(std::abs(error) / fresnel_by_angles(cosine, eta).reflected, {cosine, eta});
    } else {
      thinner.see(std::abs(error), {cosine, eta});
    }
  });
  CHECK_MESSAGE(denser.error < 1e-13, denser);
  CHECK_MESSAGE(thinner.error < 1e-7, thinner);
}

TEST_CASE("reflectance is in [0, 1] and does not ask for the cosine's sign") {
  int wrong = 0;
  for_each_surface(1e-3, 1e15, [&](float cosine, float eta) {
    const float reflected = fresnel_dielectric(cosine, eta);
    wrong += !(reflected >= 0.0f && reflected <= 1.0f && reflected == fresnel_dielectric(-cosine, eta));
  });
  CHECK(wrong == 0);
}

TEST_CASE("light reflects as much on its way out as on its way in") {
  worst_case worst;
  for (int i = 0; i < 100'000; ++i) {
    const auto [cosine, v] = even_point<2>(i);
    const double eta = 1.01 + 2.0 * v;
    const double refracted = std::cos(std::asin(std::sin(std::acos(cosine)) / eta));
    worst.see(std::abs(fresnel_dielectric(refracted, 1.0 / eta) - fresnel_dielectric(cosine, eta)), {cosine, eta});
  }
  CHECK_MESSAGE(worst.error < 1e-9, worst);
}

TEST_CASE("beyond the critical angle all is reflected") {
  for_each_surface(1e-3, 0.999, [](float cosine, float eta) {
    const double sine2 = (1.0 - cosine) * (1.0 + cosine);
    if (sine2 > 1.000001 * eta * eta) REQUIRE(fresnel_dielectric(cosine, eta) == 1.0f);
  });
}

TEST_CASE("grazing light is reflected whole") {
  for (float eta = 1e-3f; eta < 1e6f; eta *= 1.37f) {
    CHECK(fresnel_dielectric(0.0f, eta) == 1.0f);
    CHECK(fresnel_dielectric(-0.0f, eta) == 1.0f);
  }
  CHECK(fresnel_dielectric(0.0f, 1.0f) == 1.0f);
}

TEST_CASE("without a change of index nothing is reflected, down to a cosine of 1e-18") {
  for (float cosine = 1.0f; cosine >= 1e-18f; cosine *= 0.97f) {
    CHECK(fresnel_dielectric(cosine, 1.0f) == 0.0f);
  }
}

TEST_CASE("a cosine above 1 counts as 1, NaN reflects all") {
  CHECK(fresnel_dielectric(1.5f, 1.55f) == fresnel_dielectric(1.0f, 1.55f));
  CHECK(fresnel_dielectric(-inf, 1.55f) == fresnel_dielectric(1.0f, 1.55f));
  CHECK(fresnel_dielectric(nan, 1.55f) == 1.0f);
  CHECK(fresnel_dielectric(0.5f, nan) == 1.0f);
  CHECK(fresnel_dielectric(nan, nan) == 1.0f);
}

TEST_CASE("a fibre passes what neither of its two surfaces reflects") {
  worst_case worst;
  bool in_range = true;
  for (int i = 0; i < 100'000; ++i) {
    const auto [u, v] = even_point<2>(i);
    const float eta = static_cast<float>(1.0 + 2.0 * u);
    const float sine = static_cast<float>(2.0 * v - 1.0);
    const double inclined = std::cos(std::asin(static_cast<double>(sine)));
    const double passed = std::pow(1.0 - fresnel_by_angles(inclined, eta).reflected, 2.0);
    const float attenuation = fibre_attenuation(eta, sine);
    in_range = in_range && attenuation >= 0.0f && attenuation <= 1.0f;
    worst.see(std::abs(attenuation - passed), {eta, sine});
  }
  CHECK(in_range);
  CHECK_MESSAGE(worst.error < 1e-6, worst);
}

TEST_CASE("a fibre's opacity is what does not pass, also where next to nothing is stopped") {
  worst_case worst;
  worst_case sum;
  for_each_surface(1.001, 3.0, [&](float cosine, float eta) {
    if (eta == 1.0f) return;
    const float sine = static_cast<float>(std::sqrt((1.0 - cosine) * (1.0 + cosine)));
    const double inclined = std::sqrt((1.0 - static_cast<double>(sine)) * (1.0 + static_cast<double>(sine)));
    const shares_by_angles surface = fresnel_by_angles(inclined, eta);
    const double stopped = surface.reflected * (1.0 + surface.transmitted);
    const float opacity = fibre_opacity(eta, sine);
    worst.see(std::abs(opacity - stopped) / stopped, {cosine, eta});
    sum.see(std::abs(1.0 - static_cast<double>(opacity) - static_cast<double>(fibre_attenuation(eta, sine))),
            {cosine, eta});
  });
  CHECK_MESSAGE(worst.error < 2e-6, worst);
  CHECK_MESSAGE(sum.error < 1e-6, sum);
}

TEST_CASE("across a hair of index 1.55 nine parts in a hundred are stopped, at Brewster's angle sixteen") {
  // F = (0.55 / 2.55)² = 0.0465206, and 1 - (1 - F)² = 0.0908770. At tan θ = 1.55 only one polarisation reflects:
  // F = ½ ((1.55² - 1) / (1.55² + 1))² = 0.0849531, and 1 - (1 - F)² = 0.1626893.
  CHECK(fibre_opacity(1.55, 0.0) == doctest::Approx(0.09087697468264433).epsilon(1e-12));
  CHECK(fibre_opacity(1.55, 1.55 / std::sqrt(1.0 + 1.55 * 1.55)) ==
        doctest::Approx(0.16268925858906014).epsilon(1e-12));
}

TEST_CASE("light along a fibre, beyond it, or NaN does not pass") {
  for (const float sine : {1.0f, -1.0f, 1.5f, -inf, nan}) {
    CHECK(fibre_attenuation(1.55f, sine) == 0.0f);
    CHECK(fibre_opacity(1.55f, sine) == 1.0f);
  }
  CHECK(fibre_attenuation(nan, 0.5f) == 0.0f);
  CHECK(fibre_opacity(nan, 0.5f) == 1.0f);
  CHECK(fibre_opacity(1.0f, 0.5f) == 0.0f);
}

}  // namespace pelage::test
