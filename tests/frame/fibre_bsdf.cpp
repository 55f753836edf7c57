// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/fibre_bsdf.hpp"

#include <pelage/bsdf/dual_scattering_table.hpp>
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/bsdf/passage.hpp>

#include "frame/built_in.hpp"
#include "frame/fibres.hpp"
#include "frame/frame.hpp"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <limits>

namespace pelage::test {

using namespace frame;

constexpr bsdf_model all_models[]{bsdf_model::kajiya_kay, bsdf_model::marschner, bsdf_model::chiang,
                                  bsdf_model::dual_scattering};
constexpr bsdf_model single_fibres[]{bsdf_model::marschner, bsdf_model::chiang};
constexpr hair_colour all_colours[]{hair_colour::blond, hair_colour::red, hair_colour::brown, hair_colour::black};
constexpr melanin<float> clear{0.0F, 0.0F};
constexpr passage unshadowed{1.0F, 0.0F, 1.0F};
constexpr float pi = glm::pi<float>();

fibre_look look_of(bsdf_model model, melanin<float> pigment) {
  fibre_look look;
  look.model = model;
  look.pigment = pigment;
  return look;
}

/// A direction in the frame of a fibre along x.
glm::vec3 direction(float theta, float phi) {
  return {std::sin(theta), std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi)};
}

/// A fibre along x seen from an inclination.
fibre_place seen_from(float theta) {
  return {{1.0F, 0.0F, 0.0F}, direction(theta, 0.0F), {0.5F, 0.4F, 0.3F}, 1.0F};
}

/// ∫ scatter for light of radiance 1 from everywhere; a light's colour is its irradiance over π.
glm::dvec3 furnace(const fibre_bsdf& bsdf, const fibre_place& at) {
  constexpr int rows = 360, columns = 180;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < rows; ++i) {
    const float theta = ((static_cast<float>(i) + 0.5F) / rows - 0.5F) * pi;
    for (int k = 0; k < columns; ++k) {
      const float phi = (static_cast<float>(k) + 0.5F) / columns * pi;
      sum += glm::dvec3(std::cos(theta) * bsdf.scatter(at, direction(theta, phi), unshadowed));
    }
  }
  return sum * (2.0 * glm::pi<double>() / (rows * columns));  // both halves of the sphere, and 1/π
}

std::array<float, 3> channels(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

TEST_CASE("every result is finite and not negative, whatever the vectors, the look and the shadow") {
  std::vector<fibre_bsdf> all;
  for (const bsdf_model model : all_models) {
    for (const melanin<float> pigment : {clear, melanin_of<float>(hair_colour::red), melanin<float>{100.0F, 100.0F}}) {
      for (const float beta : {0.05F, 0.3F, 1.0F}) {
        fibre_look look = look_of(model, pigment);
        look.beta_m = look.beta_n = beta;
        look.eta = beta < 0.1F ? 1.0F : 1.55F;
        look.tilt = beta < 0.5F ? 20.0F : -20.0F;
        all.emplace_back(look);
      }
    }
  }
  holds("finite and not negative", [&] {
    const auto any_direction = [] {
      const float nan = std::numeric_limits<float>::quiet_NaN();
      const glm::vec3 special[]{glm::vec3(0.0F), glm::vec3(nan), {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
      const int which = *rc::gen::inRange(0, 12);
      if (which < 6) return special[which];
      return direction(any_float(-1.6F, 1.6F), any_float(-4.0F, 4.0F));
    };
    const fibre_place at{any_direction(), any_direction(), glm::vec3(any_float(0.0F, 1.0F)), any_float(0.0F, 1.0F)};
    const glm::vec3 to_light = any_direction();
    const float open = any_float(0.0F, 1.0F);
    const passage ways[]{unshadowed,
                         {0.0F, 0.0F, 0.0F},
                         {0.0F, 4096.0F, 1.0F},
                         {open * any_float(0.0F, 1.0F), any_float(0.0F, 50.0F), open}};
    const passage passed = ways[*rc::gen::inRange(0, 4)];
    for (const fibre_bsdf& bsdf : all) {
      for (const float x : channels(bsdf.scatter(at, to_light, passed)))
        RC_ASSERT(x >= 0.0F && x < std::numeric_limits<float>::infinity());
      for (const float x : channels(bsdf.reflect_sky(at)))
        RC_ASSERT(x >= 0.0F && x <= 1.01F);
    }
  });
}

TEST_CASE("lit evenly from all sides a fibre shows its albedo: all of the light where it has no pigment, never more") {
  for (const bsdf_model model : single_fibres) {
    for (const float theta : {-1.2F, 0.0F, 0.8F}) {
      CAPTURE(static_cast<int>(model));
      CAPTURE(theta);
      const fibre_place at = seen_from(theta);
      const fibre_bsdf white(look_of(model, clear));
      // Marschner's leaves out what is reflected inside more than once, and its M is normalised for one inclination.
      const double all = furnace(white, at).x;
      CHECK(all > (model == bsdf_model::chiang ? 0.995 : 0.75));
      CHECK(all < (model == bsdf_model::chiang ? 1.005 : 1.1));
      for (const hair_colour colour : all_colours) {
        const fibre_bsdf hair(look_of(model, melanin_of<float>(colour)));
        const glm::dvec3 lit = furnace(hair, at);
        const glm::dvec3 albedo(hair.reflect_sky(at));
        for (int c = 0; c < 3; ++c) {
          CHECK(lit[c] < all);
          CHECK(lit[c] == doctest::Approx(albedo[c]).epsilon(model == bsdf_model::chiang ? 0.005 : 0.12));
        }
      }
    }
  }
}

}  // namespace pelage::test
