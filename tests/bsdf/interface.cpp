// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/interface.hpp>

#include <property.hpp>

#include <cmath>

using namespace pelage;

TEST_CASE("the two shares are the Fresnel reflectance and what it leaves") {
  test::holds("reflected is fresnel_dielectric, transmitted its complement", [](std::uint16_t a, std::uint16_t b) {
    const double cosine = (a + 1) / 65536.0;
    const double eta = 1.0 + b / 65536.0;
    const interface_shares<double> shares = dielectric_interface(cosine, eta);
    RC_ASSERT(std::abs(shares.reflected - fresnel_dielectric(cosine, eta)) < 1e-14);
    RC_ASSERT(std::abs(shares.reflected + shares.transmitted - 1.0) < 1e-14);
  });
}

TEST_CASE("both shares keep their digits in float, to grazing incidence and to an index of nearly 1") {
  double worst = 0.0;
  for (double cosine = 1e-6; cosine <= 1.0; cosine *= 1.1) {
    for (const float eta : {1.01f, 1.3f, 1.55f, 2.5f}) {
      const float rounded = static_cast<float>(cosine);
      const interface_shares<float> narrow = dielectric_interface(rounded, eta);
      const interface_shares<double> wide = dielectric_interface<double>(rounded, eta);
      worst = std::max(worst, std::abs(narrow.transmitted / wide.transmitted - 1.0));
      if (eta > 1.1f) {
        worst = std::max(worst, std::abs(narrow.reflected / wide.reflected - 1.0));
      }
    }
  }
  CHECK(worst < 1e-6);
}

TEST_CASE("grazing light and total reflection enter nothing") {
  CHECK(dielectric_interface(0.0f, 1.55f).reflected == 1.0f);
  CHECK(dielectric_interface(0.0f, 1.55f).transmitted == 0.0f);
  CHECK(dielectric_interface(0.2f, 0.7f).reflected == 1.0f);
  CHECK(dielectric_interface(0.2f, 0.7f).transmitted == 0.0f);
  CHECK(dielectric_interface(0.0f, 1.0f).reflected == 1.0f);
}

TEST_CASE("an index of 1 reflects nothing") {
  CHECK(dielectric_interface(0.3f, 1.0f).reflected < 1e-14f);
  CHECK(dielectric_interface(0.3f, 1.0f).transmitted == doctest::Approx(1.0).epsilon(1e-6));
}

TEST_CASE("at θ = 0 the Bravais indices are the index, and the interface is the ordinary one") {
  const double cosine = 0.6;
  const double inside = std::sqrt(1.0 - 0.64 / (1.55 * 1.55));
  const interface_shares<double> bravais = bravais_interface(cosine, inside, 1.55, 1.55);
  CHECK(bravais.reflected == doctest::Approx(fresnel_dielectric(cosine, 1.55)).epsilon(1e-13));
}
