// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/interface.hpp>

#include "bsdf/surfaces.hpp"
#include "property.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace pelage;

TEST_CASE("both shares keep their digits in float, from grazing to normal incidence, for an index from 1 to 1000") {
  test::worst_case reflected;
  test::worst_case transmitted;
  test::for_each_surface(1.5, 1000.0, [&](float cosine, float eta) {
    const interface_shares<float> shares = dielectric_interface(cosine, eta);
    const test::shares_by_angles exact = test::fresnel_by_angles(cosine, eta);
    reflected.see(test::relative_error(shares.reflected, exact.reflected), {cosine, eta});
    transmitted.see(test::relative_error(shares.transmitted, exact.transmitted), {cosine, eta});
  });
  // The worst by climbing, and down to cosines of 1e-30.
  const auto error = [](const std::vector<double>& in) {
    const auto cosine = static_cast<float>(in[0]);
    const auto eta = static_cast<float>(in[1]);
    if (!(cosine >= 1e-30f && cosine <= 1.0f && eta > 1.0f && eta <= 1000.0f)) return 0.0;
    const interface_shares<float> shares = dielectric_interface(cosine, eta);
    const test::shares_by_angles exact = test::fresnel_by_cosines(cosine, eta);
    return std::max(test::relative_error(shares.reflected, exact.reflected),
                    test::relative_error(shares.transmitted, exact.transmitted));
  };
  for (int i = 0; i < 20'000; ++i) {
    const auto [u, v] = test::even_point<2>(i);
    const std::vector<double> in{test::on_log_scale(u, 1e-30, 1.0), test::on_log_scale(v, 1.0, 1000.0)};
    transmitted.see(error(in), {in[0], in[1]});
  }
  for (test::worst_case* worst : {&reflected, &transmitted}) {
    test::climb(*worst, 40'000, error);
    CHECK_MESSAGE(worst->error < 1.3e-6, *worst);
  }
}

TEST_CASE("what a denser medium does not reflect enters it") {
  test::for_each_surface(1.5, 1e17, [](float cosine, float eta) {
    const interface_shares<float> shares = dielectric_interface(cosine, eta);
    REQUIRE(shares.reflected >= 0.0f);
    REQUIRE(shares.transmitted >= 0.0f);
    REQUIRE(std::abs(shares.reflected + shares.transmitted - 1.0f) < 1e-6f);
  });
}

TEST_CASE("grazing light and total reflection enter nothing") {
  CHECK(dielectric_interface(0.0f, 1.55f).reflected == 1.0f);
  CHECK(dielectric_interface(0.0f, 1.55f).transmitted == 0.0f);
  CHECK(dielectric_interface(0.2f, 0.7f).reflected == 1.0f);
  CHECK(dielectric_interface(0.2f, 0.7f).transmitted == 0.0f);
  CHECK(dielectric_interface(0.0f, 1.0f).reflected == 1.0f);
  CHECK(dielectric_interface(0.5f, std::numeric_limits<float>::quiet_NaN()).reflected == 1.0f);
  CHECK(dielectric_interface(0.5f, std::numeric_limits<float>::quiet_NaN()).transmitted == 0.0f);
}

TEST_CASE("beside the critical angle both shares are within 8e-3, down to an index of 0.3") {
  test::worst_case worst;
  for (float eta = 0.3f; eta < 1.0f; eta = std::nextafter(eta * 1.00001f, 1.0f)) {
    float cosine = static_cast<float>(std::sqrt((1.0 - static_cast<double>(eta)) * (1.0 + static_cast<double>(eta))));
    for (int step = 0; step < 2; ++step)
      cosine = std::nextafter(cosine, 0.0f);
    for (int step = 0; step < 4; ++step, cosine = std::nextafter(cosine, 1.0f)) {
      const interface_shares<float> shares = dielectric_interface(cosine, eta);
      const test::shares_by_angles exact = test::fresnel_by_angles(cosine, eta);
      worst.see(std::abs(shares.reflected - exact.reflected), {cosine, eta});
      worst.see(std::abs(shares.transmitted - exact.transmitted), {cosine, eta});
    }
  }
  CHECK_MESSAGE(worst.error < 8e-3, worst);
  CHECK_MESSAGE(worst.error > 7e-3, worst);  // the bound is not far
  CHECK(worst.error > 5e-4);
}

TEST_CASE("an index of 1 reflects nothing") {
  CHECK(dielectric_interface(0.3f, 1.0f).reflected == 0.0f);
  CHECK(dielectric_interface(0.3f, 1.0f).transmitted == doctest::Approx(1.0).epsilon(2e-7));
}

TEST_CASE("at θ = 0 the Bravais indices are the index, and the interface is the ordinary one") {
  const double cosine = 0.6;
  const double inside = std::sqrt(1.0 - 0.64 / (1.55 * 1.55));
  const interface_shares<double> bravais = bravais_interface(cosine, inside, 1.55, 1.55);
  CHECK(bravais.reflected == doctest::Approx(fresnel_dielectric(cosine, 1.55)).epsilon(1e-13));
}
