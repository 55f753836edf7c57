// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/fibre_bsdf.hpp"

#include <pelage/bsdf/dual_scattering_table.hpp>
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/bsdf/passage.hpp>

#include "frame/fibres.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

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

fibre_bsdf bsdf_of(const fibre_look& look) {
  return {look, glm::vec3(0.5F)};
}

/// ∫ scatter for light of radiance `sky(φ)`, φ from the eye, from everywhere; a light's colour is its irradiance over
/// π.
template <class Sky>
glm::dvec3 furnace(const fibre_bsdf& bsdf, const fibre_place& at, Sky&& sky) {
  constexpr int rows = 360, columns = 180;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < rows; ++i) {
    const float theta = ((static_cast<float>(i) + 0.5F) / rows - 0.5F) * pi;
    for (int k = 0; k < columns; ++k) {
      const float phi = (static_cast<float>(k) + 0.5F) / columns * pi;
      sum += glm::dvec3(sky(phi) * std::cos(theta) * bsdf.scatter(at, direction(theta, phi), unshadowed));
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
    for (const melanin<float> pigment : {clear, melanin<float>{100.0F, 100.0F}}) {
      for (const float beta : {0.05F, 1.0F}) {
        fibre_look look = look_of(model, pigment);
        look.beta_m = look.beta_n = beta;
        look.eta = beta < 0.1F ? 1.0F : 1.55F;
        look.tilt = beta < 0.5F ? 20.0F : -20.0F;
        all.push_back(bsdf_of(look));
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
        RC_ASSERT(x >= 0.0F && x <= 2.0F);
    }
  });
}

TEST_CASE(
    "lit evenly from all sides a fibre without pigment is as bright as what lights it; with pigment it is darker") {
  const auto even = [](float) { return 1.0F; };
  for (const bsdf_model model : single_fibres) {
    for (const float theta : {-1.2F, 0.0F, 0.8F}) {
      CAPTURE(static_cast<int>(model));
      CAPTURE(theta);
      const double all = furnace(bsdf_of(look_of(model, clear)), seen_from(theta), even).x;
      // Marschner's leaves out what is reflected inside more than once, and its M is normalised for one inclination.
      CHECK(all > (model == bsdf_model::chiang ? 0.995 : 0.75));
      CHECK(all < (model == bsdf_model::chiang ? 1.005 : 1.05));
      for (const hair_colour colour : all_colours) {
        const glm::dvec3 lit = furnace(bsdf_of(look_of(model, melanin_of<float>(colour))), seen_from(theta), even);
        CHECK(lit.x < all);
        CHECK(lit.y < lit.x);
        CHECK(lit.z < lit.y);
      }
    }
  }
}

TEST_CASE("the sky's light is what comes from the eye's side, scattered by the model itself") {
  const auto from_the_eye = [](float phi) { return 2.0F * (1.0F - phi / pi); };
  for (const bsdf_model model : {bsdf_model::marschner, bsdf_model::chiang, bsdf_model::dual_scattering}) {
    const double within = model == bsdf_model::chiang ? 0.005 : 0.06;
    for (const float theta : {-0.6F, 0.0F}) {
      CAPTURE(static_cast<int>(model));
      CAPTURE(theta);
      const fibre_place at = seen_from(theta);
      const fibre_bsdf hair = bsdf_of(look_of(model, melanin_of<float>(hair_colour::blond)));
      const glm::dvec3 lit = furnace(hair, at, from_the_eye);
      const glm::dvec3 shown(hair.reflect_sky(at));
      for (int c = 0; c < 3; ++c)
        CHECK(shown[c] == doctest::Approx(lit[c]).epsilon(within));
    }
  }
}

/// Inclinations and azimuths that the tables' bounds are for.
template <class Check>
void over_directions(Check&& check) {
  for (const float theta_i : {-1.1F, -0.4F, 0.07F, 0.9F}) {
    for (const float theta_r : {-0.85F, -0.1F, 0.45F, 1.15F}) {
      for (int k = 0; k <= 60; ++k)
        check(theta_i, theta_r, pi * static_cast<float>(k) / 60.0F);
    }
  }
}

/// What a model sends of unit irradiance from (θ_i, φ) to θ_r.
glm::vec3 sent(const fibre_bsdf& bsdf, float theta_i, float theta_r, float phi, const passage& passed = unshadowed) {
  return bsdf.scatter(seen_from(theta_r), direction(theta_i, phi), passed) / pi;
}

TEST_CASE("the choice is the header's model, within the tables' bounds") {
  fibre_look look = look_of(bsdf_model::marschner, melanin_of<float>(hair_colour::red));
  const std::array<float, 3> sigma_a = absorption_of(*look.pigment);
  const float tilt = -glm::radians(look.tilt);
  marschner_parameters<float> smooth = common_marschner_parameters(sigma_a);
  smooth.alpha = tilt;
  smooth.beta = 0.5F * std::sqrt(longitudinal_variance(look.beta_m));
  const auto rough = make_chiang_fibre<float>({look.eta, sigma_a, look.beta_m, look.beta_n, tilt});

  const fibre_bsdf marschner = bsdf_of(look);
  look.model = bsdf_model::chiang;
  const fibre_bsdf chiang = bsdf_of(look);
  float marschner_peak = 0, marschner_error = 0, chiang_peak = 0, chiang_error = 0;
  over_directions([&](float theta_i, float theta_r, float phi) {
    const auto s = evaluate_marschner(smooth, theta_i, theta_r, phi, 0.0F).scattering;
    const float expected = 0.5F * s[0] * std::cos(theta_i);
    marschner_peak = std::max(marschner_peak, expected);
    marschner_error = std::max(marschner_error, std::abs(sent(marschner, theta_i, theta_r, phi).x - expected));
    const auto f = evaluate_chiang_far(rough, fibre_direction_of(direction(theta_r, 0.0F)),
                                       fibre_direction_of(direction(theta_i, phi)));
    chiang_peak = std::max(chiang_peak, f.value[0]);
    chiang_error = std::max(chiang_error, std::abs(sent(chiang, theta_i, theta_r, phi).x - f.value[0]));
  });
  CHECK(marschner_error < 0.04F * marschner_peak);
  CHECK(chiang_error < 0.01F * chiang_peak);

  const fibre_place at = seen_from(0.3F);
  const kajiya_kay_lobes lobes = kajiya_kay(at.tangent, direction(-0.2F, 0.4F), at.to_eye, 60.0F);
  const glm::vec3 grey = bsdf_of({}).scatter(at, direction(-0.2F, 0.4F), unshadowed);
  CHECK(grey.y - grey.z == doctest::Approx((at.colour.y - at.colour.z) * 0.55F * lobes.diffuse));
}

TEST_CASE("Kajiya-Kay's fibre with pigment has the colour of a mass of such hair") {
  const melanin<float> blond = melanin_of<float>(hair_colour::blond);
  const std::array<float, 3> sigma_a = absorption_of(blond);
  fibre_place at = seen_from(0.3F);
  const fibre_bsdf pigmented = bsdf_of(look_of(bsdf_model::kajiya_kay, blond));
  const glm::vec3 shown = pigmented.scatter(at, direction(0.2F, 1.0F), unshadowed);
  for (int c = 0; c < 3; ++c)
    at.colour[c] = albedo_from_absorption(sigma_a[static_cast<std::size_t>(c)], 0.3F);
  CHECK(shown == bsdf_of({}).scatter(at, direction(0.2F, 1.0F), unshadowed));
  CHECK(pigmented.reflect_sky(at) == at.colour);
}

TEST_CASE("without a pigment fibres absorb what gives a mass of them their own colour") {
  fibre_look look;
  look.model = bsdf_model::chiang;
  const melanin<float> brown = melanin_of<float>(hair_colour::brown);
  const std::array<float, 3> sigma_a = absorption_of(brown);
  glm::vec3 colour;
  for (int c = 0; c < 3; ++c)
    colour[c] = albedo_from_absorption(sigma_a[static_cast<std::size_t>(c)], look.beta_n);
  const fibre_bsdf own(look, colour);
  look.pigment = brown;
  const fibre_bsdf pigmented(look, glm::vec3(1.0F));
  over_directions([&](float theta_i, float theta_r, float phi) {
    const glm::vec3 a = sent(own, theta_i, theta_r, phi);
    const glm::vec3 b = sent(pigmented, theta_i, theta_r, phi);
    for (int c = 0; c < 3; ++c)
      CHECK(a[c] == doctest::Approx(b[c]).epsilon(1e-3));
  });
}

TEST_CASE("Marschner's fibre sends from one direction to another what it sends back") {
  const fibre_bsdf hair = bsdf_of(look_of(bsdf_model::marschner, melanin_of<float>(hair_colour::blond)));
  over_directions([&](float theta_i, float theta_r, float phi) {
    const float there = sent(hair, theta_i, theta_r, phi).y / std::cos(theta_i);
    const float back = sent(hair, theta_r, theta_i, phi).y / std::cos(theta_r);
    CHECK(there == doctest::Approx(back).epsilon(1e-3));
  });
}

TEST_CASE("turning fibre, light and eye together changes nothing") {
  for (const bsdf_model model : all_models) {
    const fibre_bsdf hair = bsdf_of(look_of(model, melanin_of<float>(hair_colour::red)));
    holds("turned, model " + std::to_string(static_cast<int>(model)), [&] {
      fibre_place at = seen_from(any_float(-1.4F, 1.4F));
      const glm::vec3 to_light = direction(any_float(-1.4F, 1.4F), any_float(-3.1F, 3.1F));
      const passage passed{0.4F, 1.5F, 0.9F};
      const glm::vec3 before = hair.scatter(at, to_light, passed);
      const glm::quat turn = glm::normalize(
          glm::quat(any_float(0.1F, 1.0F), any_float(-1.0F, 1.0F), any_float(-1.0F, 1.0F), any_float(-1.0F, 1.0F)));
      at.tangent = turn * at.tangent;
      at.to_eye = turn * at.to_eye;
      const glm::vec3 after = hair.scatter(at, turn * to_light, passed);
      for (int c = 0; c < 3; ++c)
        RC_ASSERT(std::abs(after[c] - before[c]) <= 2e-3F * (0.05F + before[c]));
    });
  }
}

TEST_CASE("of the light that fibres in the way meet, what their TT lobe passes arrives") {
  fibre_look look = look_of(bsdf_model::chiang, melanin_of<float>(hair_colour::red));
  for (const bsdf_model model : single_fibres) {
    look.model = model;
    const fibre_bsdf hair = bsdf_of(look);
    // At normal incidence Bravais indices are the index itself, and the two models' TT is one.
    for (const float theta : {0.0F, model == bsdf_model::chiang ? -0.9F : 0.0F}) {
      const glm::vec3 kept = mean_passage<16>(look.eta, absorption_of(*look.pigment), std::sin(theta));
      const glm::vec3 free = sent(hair, theta, 0.4F, 1.0F);
      const glm::vec3 shaded = sent(hair, theta, 0.4F, 1.0F, {0.3F, 2.0F, 0.8F});
      for (int c = 0; c < 3; ++c) {
        CHECK(shaded[c] / free[c] == doctest::Approx(0.8F * std::pow(0.3F / 0.8F, 1.0F - kept[c])).epsilon(0.01));
      }
    }
    CHECK(sent(hair, 0.1F, 0.4F, 1.0F, {0.0F, 3.0F, 1.0F}) == glm::vec3(0.0F));
  }
  // A fibre that neither bends nor absorbs light passes all of it.
  look.model = bsdf_model::chiang;
  look.pigment = clear;
  look.eta = 1.0F;
  const fibre_bsdf air = bsdf_of(look);
  const glm::vec3 free = sent(air, 0.0F, 0.1F, 3.0F);
  CHECK(sent(air, 0.0F, 0.1F, 3.0F, {0.2F, 2.0F, 1.0F}).x == doctest::Approx(free.x).epsilon(0.01));
}

TEST_CASE("dual scattering is the header's, on averages of the header's fibre") {
  const fibre_look look = look_of(bsdf_model::dual_scattering, melanin_of<float>(hair_colour::blond));
  const fibre_bsdf hair = bsdf_of(look);
  const auto fibre = make_chiang_fibre<float>(
      {look.eta, absorption_of(*look.pigment), look.beta_m, look.beta_n, -glm::radians(look.tilt)});
  const chiang_fibre_model<float> model{fibre};
  const dual_density<float> density{0.7F, 0.7F};
  const passage passed{0.3F, 2.5F, 0.9F};
  constexpr float opacity = 0.6F;
  for (const float theta_i : {-0.5F, 0.2F}) {
    const dual_averages<float> averages = average_fibre(model, theta_i, 128U, 32U);
    const dual_local<float> local = dual_local_scattering(averages, density);
    const dual_global<float> global =
        dual_global_scattering(averages, density, opacity * passed.fibres, passed.transmittance / passed.open);
    for (const float theta_r : {-0.3F, 0.1F, 0.6F}) {
      for (const float phi : {0.1F, 1.5F, 3.0F}) {
        fibre_place at = seen_from(theta_r);
        at.opacity = opacity;
        const glm::vec3 shown = hair.scatter(at, direction(theta_i, phi), passed) / pi;
        const auto once =
            evaluate_chiang_far(fibre, fibre_direction_of(at.to_eye), fibre_direction_of(direction(theta_i, phi)));
        const float cos_d = std::cos(0.5F * (theta_r - theta_i));
        const float to_radiance = std::cos(theta_i) * std::cos(theta_r) / (cos_d * cos_d);
        const glm::vec3 many =
            dual_scattering(averages, local, global, density, glm::vec3(0.0F), theta_i, theta_r, phi);
        for (int c = 0; c < 3; ++c) {
          const float expected = passed.transmittance * once.value[c] + passed.open * to_radiance * many[c];
          CHECK(shown[c] == doctest::Approx(expected).epsilon(0.02));
        }
      }
    }
  }
}

TEST_CASE("a look out of range is refused") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refused = [](auto&& change) {
    fibre_look look;
    change(look);
    CHECK_THROWS_AS(bsdf_of(look), std::invalid_argument);
  };
  for (const float eta : {0.99F, 3.01F, nan})
    refused([&](fibre_look& look) { look.eta = eta; });
  for (const float beta : {0.0F, 1.01F, nan}) {
    refused([&](fibre_look& look) { look.beta_m = beta; });
    refused([&](fibre_look& look) { look.beta_n = beta; });
  }
  for (const float tilt : {-21.0F, 21.0F, nan})
    refused([&](fibre_look& look) { look.tilt = tilt; });
  for (const float pigment : {-0.1F, 101.0F, nan}) {
    refused([&](fibre_look& look) { look.pigment = melanin<float>{pigment, 0.0F}; });
    refused([&](fibre_look& look) { look.pigment = melanin<float>{0.0F, pigment}; });
  }
}

}  // namespace pelage::test
