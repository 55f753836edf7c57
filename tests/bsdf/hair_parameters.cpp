// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_sampling.hpp>
#include <pelage/bsdf/hair_parameters.hpp>

#include <property.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <random>

using namespace pelage;

namespace {

/// The albedo of a thick mass of fibres that lie in all directions, lit from all directions: photons walk from fibre
/// to fibre with exponential steps until they leave, each fibre hit at an even place across its width and scattering
/// by the BSDF.
double albedo_of_mass(double sigma_a, double beta_n, int photons) {
  const auto fibre = make_chiang_fibre<double>({1.55, {sigma_a, sigma_a, sigma_a}, 0.3, beta_n, 0.0});
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> draw(0.0, 1.0);
  const auto random_direction = [&] {
    const double z = 2.0 * draw(generator) - 1.0;
    const double phi = 2.0 * std::numbers::pi * draw(generator);
    const double r = std::sqrt(1.0 - z * z);
    return glm::dvec3(r * std::cos(phi), r * std::sin(phi), z);
  };
  double escaped = 0.0;
  for (int k = 0; k < photons; ++k) {
    double depth = 0.0;
    double weight = 1.0;
    glm::dvec3 towards = random_direction();
    towards.z = -std::sqrt(draw(generator));  // even over the surface, downwards
    const double across = std::sqrt(1.0 - towards.z * towards.z) / std::hypot(towards.x, towards.y);
    towards.x *= across;
    towards.y *= across;
    for (int step = 0; step < 400 && weight > 1e-3; ++step) {
      depth -= towards.z * -std::log(1.0 - draw(generator));
      if (depth < 0.0) {
        escaped += weight;
        break;
      }
      const glm::dvec3 x = random_direction();
      const glm::dvec3 y =
          glm::normalize(glm::cross(x, std::abs(x.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
      const glm::dvec3 z = glm::cross(x, y);
      const glm::dvec3 eye(glm::dot(-towards, x), glm::dot(-towards, y), glm::dot(-towards, z));
      const auto view = view_chiang(fibre, 2.0 * draw(generator) - 1.0, fibre_direction_of(eye));
      const auto sample = sample_chiang(
          fibre, view, std::array<double, 4>{draw(generator), draw(generator), draw(generator), draw(generator)});
      weight *= sample.result.value[0] / sample.result.density;
      towards = sample.direction.x * x + sample.direction.y * y + sample.direction.z * z;
    }
  }
  return escaped / photons;
}

}  // namespace

TEST_CASE("pigments absorb blue most, and eumelanin in proportion to its concentration") {
  for (const hair_colour colour : {hair_colour::blond, hair_colour::red, hair_colour::brown, hair_colour::black}) {
    const auto sigma = absorption_of(melanin_of<double>(colour));
    CHECK(sigma[0] < sigma[1]);
    CHECK(sigma[1] < sigma[2]);
  }
  CHECK(absorption_of(melanin<double>{2.0, 0.0})[1] == doctest::Approx(2.0 * 0.697).epsilon(1e-15));
  CHECK(absorption_of(melanin<double>{0.0, 2.0})[0] == doctest::Approx(2.0 * 0.187).epsilon(1e-15));
  CHECK(absorption_of(melanin<double>{0.0, 0.0})[2] == 0.0);
}

TEST_CASE("presets go from light to dark, and red hair is the reddest") {
  const auto sigma = [](hair_colour colour) { return absorption_of(melanin_of<double>(colour)); };
  CHECK(sigma(hair_colour::blond)[1] < sigma(hair_colour::red)[1]);
  CHECK(sigma(hair_colour::blond)[1] < sigma(hair_colour::brown)[1]);
  CHECK(sigma(hair_colour::brown)[1] < sigma(hair_colour::black)[1]);
  const auto redness = [&](hair_colour colour) { return sigma(colour)[2] / sigma(colour)[0]; };
  CHECK(redness(hair_colour::red) > redness(hair_colour::blond));
  CHECK(redness(hair_colour::red) > redness(hair_colour::black));
}

TEST_CASE("the artist's controls start at clear and end at black") {
  CHECK(melanin_from_controls(0.0, 0.5).eumelanin == 0.0);
  CHECK(melanin_from_controls(1.0, 0.0).eumelanin == doctest::Approx(40.0).epsilon(1e-6));
  CHECK(melanin_from_controls(1.0f, 0.0f).eumelanin == doctest::Approx(40.0).epsilon(1e-5));
  const auto half = melanin_from_controls(0.5, 0.25);
  CHECK(half.pheomelanin / (half.pheomelanin + half.eumelanin) == doctest::Approx(0.25).epsilon(1e-12));
  CHECK(melanin_from_controls(2.0, -1.0).pheomelanin == 0.0);
}

TEST_CASE("albedo and absorption are inverse to each other, in float and double") {
  test::holds("albedo_from_absorption(absorption_from_albedo(c)) = c", [](std::uint16_t c, std::uint8_t rough) {
    const double colour = 1e-3 + c / 65536.0 * 0.998;
    const double beta = rough / 255.0;
    RC_ASSERT(std::abs(albedo_from_absorption(absorption_from_albedo(colour, beta), beta) - colour) < 1e-12);
    const float narrow = static_cast<float>(colour);
    const float there = absorption_from_albedo(narrow, static_cast<float>(beta));
    RC_ASSERT(std::abs(albedo_from_absorption(there, static_cast<float>(beta)) - narrow) < 1e-5f);
  });
  CHECK(absorption_from_albedo(1.0, 0.3) == 0.0);
  CHECK(std::isfinite(absorption_from_albedo(0.0, 0.3)));
}

TEST_CASE("a mass of fibres has about the albedo that its absorption was chosen for, where one fibre is brighter") {
  double last = 0.0;
  for (const double colour : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double sigma = absorption_from_albedo(colour, 0.3);
    const double mass = albedo_of_mass(sigma, 0.3, 3000);
    MESSAGE("asked ", colour, ", a mass has ", mass);
    CHECK(std::abs(mass - colour) < 0.06);
    CHECK(mass > last);
    last = mass;
    // Straight through the axis and out again, a single fibre keeps more than the mass does.
    CHECK(std::exp(-2.0 * sigma) > colour);
  }
}

TEST_CASE("roughness remaps have the printed values and grow with roughness") {
  CHECK(longitudinal_variance(0.5) ==
        doctest::Approx(std::pow(0.726 * 0.5 + 0.812 * 0.25 + 3.7 * std::pow(0.5, 20), 2)).epsilon(1e-6));
  CHECK(azimuthal_scale(0.5) ==
        doctest::Approx(std::sqrt(std::numbers::pi / 8) * (0.265 * 0.5 + 1.194 * 0.25 + 5.372 * std::pow(0.5, 22)))
            .epsilon(1e-6));
  CHECK(longitudinal_variance(0.0) == 0.0);
  CHECK(azimuthal_scale(0.0) == 0.0);
  for (int k = 0; k < 100; ++k) {
    CHECK(longitudinal_variance((k + 1) * 0.01) > longitudinal_variance(k * 0.01));
    CHECK(azimuthal_scale((k + 1) * 0.01) > azimuthal_scale(k * 0.01));
  }
}

TEST_CASE("roughness_of_width inverts the remap and holds at its ends") {
  for (int k = 0; k <= 1000; ++k) {
    const double beta = k / 1000.0;
    CHECK(std::abs(roughness_of_width(std::sqrt(longitudinal_variance(beta))) - beta) < 1e-11);
    const auto narrow = static_cast<float>(beta);
    CHECK(std::abs(roughness_of_width(std::sqrt(longitudinal_variance(narrow))) - narrow) < 3e-7f);
  }
  CHECK(roughness_of_width(0.0) < 1e-9);
  CHECK(roughness_of_width(9.0) > 0.999999);
}
