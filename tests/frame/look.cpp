// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What the look's numbers and an ambient light do.
#include "frame/shading/fibre_bsdf.hpp"

#include "frame/fibres.hpp"
#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"
#include "frame/shading/scene.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace pelage::test {

using namespace frame;

constexpr passage unshadowed{1.0F, 0.0F, 1.0F};

glm::vec3 any_direction() {
  glm::vec3 d = any_vec3(-1.0F, 1.0F);
  if (glm::length(d) < 1e-3F) d = glm::vec3(0.0F, 1.0F, 0.0F);
  return glm::normalize(d);
}

TEST_CASE("Kajiya-Kay's fibre sends K_d sin θ of its colour and K_s cosᵖ of the way to the mirrored cone") {
  holds("diffuse and specular", [] {
    fibre_look look;
    look.diffuse = any_float(0.0F, 3.0F);
    look.specular = any_float(0.0F, 3.0F);
    look.exponent = any_float(0.0F, 200.0F);
    const fibre_place at{any_direction(), any_direction(), any_vec3(0.0F, 1.0F), 1.0F};
    const glm::vec3 to_light = any_direction();
    const glm::vec3 sent = fibre_bsdf(look, glm::vec3(0.5F)).scatter(at, to_light, unshadowed);

    // Angles from the tangent; the mirrored cone is at π - θ.
    const auto angle = [&](const glm::vec3& d) {
      const glm::dvec3 a(at.tangent);
      const glm::dvec3 b(d);
      return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    };
    const double theta = angle(to_light);
    const double off = angle(at.to_eye) - (std::acos(-1.0) - theta);
    const double highlight = std::pow(std::max(std::cos(off), 0.0), static_cast<double>(look.exponent));
    const double error = 1e-6 * (1.0 + look.exponent) * (look.diffuse + look.specular);
    for (int c = 0; c < 3; ++c) {
      const double expected = look.diffuse * std::sin(theta) * at.colour[c] + look.specular * highlight;
      if (std::abs(std::cos(off)) > 1e-6) RC_ASSERT(std::abs(sent[c] - expected) <= error);
    }
  });
}

TEST_CASE("weights and exponents beyond their ranges are refused") {
  for (const float wrong : {-1.0F, 20000.0F, std::numeric_limits<float>::quiet_NaN()}) {
    for (float fibre_look::*const one : {&fibre_look::diffuse, &fibre_look::specular, &fibre_look::exponent}) {
      fibre_look look;
      look.*one = wrong;
      CHECK_THROWS_AS(fibre_bsdf(look, glm::vec3(0.5F)), std::invalid_argument);
    }
  }
  frame_settings settings;
  settings.ambient = {0.0F, -1.0F, 0.0F};
  CHECK_THROWS_AS((void)draw_frame(make_built_in(5, 3, 1), settings, [](const std::string&, double) {}),
                  std::invalid_argument);
}

TEST_CASE("an ambient light alone is sent back by a fibre and an object as their colour, whatever stands before them") {
  const strands fibres = fibres_of({{{-1.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}}}, 0.1F, 1.0F);
  solids ball;
  ball.parts.push_back({glm::vec3(0.0F), glm::vec3(0.5F)});
  scene dark{fibres, ball, {}, {glm::vec3(0.0F), 1.0F}, glm::vec3(0.0F), fibre_bsdf({}, glm::vec3(0.5F))};
  dark.ambient = {0.5F, 0.25F, 2.0F};
  CHECK(dark.fibre_radiance(0, 0.3F, {0.0F, 0.0F, 1.0F}) == dark.ambient * fibres.colour[0]);

  wide_rays rays;
  rays.origin = filled<wide>({0.0F, 0.0F, 3.0F});
  rays.direction = filled<wide>({0.0F, 0.0F, -1.0F});
  CHECK(lane_of(dark.seen_behind(rays).radiance, 0) == ball.skin * dark.ambient);
  rays.direction = filled<wide>({0.0F, 0.0F, 1.0F});
  CHECK(lane_of(dark.seen_behind(rays).radiance, 0) == glm::vec3(0.0F));
}

TEST_CASE("ambient light makes no pixel darker and leaves the background's bits") {
  const hair_model hair = make_built_in(100, 8, 1);
  frame_settings settings;
  settings.width = settings.height = 40;
  settings.on_bust = true;
  const auto draw = [&] { return draw_frame(hair, settings, [](const std::string&, double) {}).picture; };
  const image plain = draw();
  settings.ambient = {0.3F, 0.3F, 0.3F};
  const image lit = draw();
  CHECK(lit.pixels.front() == plain.pixels.front());
  int darker = 0;
  int brighter = 0;
  for (std::size_t i = 0; i < lit.pixels.size(); ++i) {
    darker += lit.pixels[i].g < plain.pixels[i].g - 1e-4F ? 1 : 0;
    brighter += lit.pixels[i].g > plain.pixels[i].g + 0.01F ? 1 : 0;
  }
  CHECK(darker == 0);
  CHECK(brighter > 200);
}

}  // namespace pelage::test
