// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/kajiya_kay_highlights.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>

#include <cmath>

using namespace pelage;

namespace {

const glm::vec3 along(1.0f, 0.0f, 0.0f);

/// The eye's inclination at which a highlight is largest, by search.
double brightest(double theta_light, float shift) {
  double best = 0.0;
  float greatest = -1.0f;
  for (int k = -1500; k <= 1500; ++k) {
    const double theta = k * 1e-3;
    const auto light = kajiya_kay_double(along, test::unit_vector<float>(theta_light, 0.0),
                                         test::unit_vector<float>(theta, 1.0), {200.0f, shift}, {200.0f, 0.0f});
    if (light.primary > greatest) {
      greatest = light.primary;
      best = theta;
    }
  }
  return best;
}

}  // namespace

TEST_CASE("an unshifted highlight is Kajiya and Kay's") {
  test::holds("both highlights with shift 0 equal the specular lobe", [](std::int8_t a, std::int8_t b, std::uint8_t p) {
    const glm::vec3 light = test::unit_vector<float>(a / 90.0, 0.3);
    const glm::vec3 eye = test::unit_vector<float>(b / 90.0, 2.0);
    const float exponent = static_cast<float>(p);
    const auto both = kajiya_kay_double(along, light, eye, {exponent, 0.0f}, {exponent, 0.0f});
    const auto lobes = kajiya_kay(along, light, eye, exponent);
    RC_ASSERT(std::abs(both.primary - lobes.specular) < 1e-6f);
    RC_ASSERT(both.primary == both.secondary);
  });
}

TEST_CASE("a shift moves a highlight to θ_i + θ_r = shift, to the tip or to the root by its sign") {
  CHECK(brightest(0.4, 0.0f) == doctest::Approx(-0.4).epsilon(0.01));
  CHECK(brightest(0.4, 0.15f) == doctest::Approx(-0.25).epsilon(0.01));
  CHECK(brightest(0.4, -0.15f) == doctest::Approx(-0.55).epsilon(0.01));
}

TEST_CASE("the two highlights are shaped each by its own") {
  const glm::vec3 light = test::unit_vector<float>(0.3, 0.0);
  const glm::vec3 eye = test::unit_vector<float>(-0.2, 0.0);
  const auto both = kajiya_kay_double(along, light, eye, {100.0f, 0.1f}, {20.0f, -0.2f});
  CHECK(static_cast<double>(both.primary) == doctest::Approx(1.0).epsilon(1e-5));
  CHECK(static_cast<double>(both.secondary) == doctest::Approx(std::pow(std::cos(0.3), 20.0)).epsilon(1e-4));
}

TEST_CASE("a fibre of albedo kd sends out kd of the light that meets it") {
  // What meets it is sin(t, l) per unit length; what it shows in each direction is its width times the reflectance.
  const double kd = 0.6;
  const double sent = test::integrate_sphere<double>(8, 8, [&](const glm::dvec3& eye) {
    return static_cast<double>(normalised_fibre_diffuse(static_cast<float>(kd))) * std::sqrt(1.0 - eye.x * eye.x);
  });
  CHECK(sent == doctest::Approx(kd).epsilon(1e-4));
}

TEST_CASE("a tangent shifted along the normal turns the highlight about twice as far") {
  const glm::vec3 normal(0.0f, 1.0f, 0.0f);
  const glm::vec3 shifted = shifted_tangent(along, normal, 0.1f);
  CHECK(static_cast<double>(glm::dot(shifted, shifted)) == doctest::Approx(1.0).epsilon(1e-6));
  // Light and eye in the plane of tangent and normal: the mirrored eye moves by twice the tangent's turn.
  const double turn = std::atan(0.1);
  const glm::vec3 light = test::unit_vector<float>(0.3, 0.0);
  const glm::vec3 eye = test::unit_vector<float>(-0.3 - 2.0 * turn, 0.0);
  CHECK(static_cast<double>(kajiya_kay(shifted, light, eye, 300.0f).specular) == doctest::Approx(1.0).epsilon(1e-4));
  CHECK(shifted_tangent(along, along, -1.0f) == along);
}
