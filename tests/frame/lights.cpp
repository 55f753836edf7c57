// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/lights.hpp"

#include "frame/fibres.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace pelage::test {

using namespace frame;

/// On the unit sphere, by height and turn.
glm::vec3 unit_at(float height, float turn) {
  const float across = std::sqrt(1.0F - height * height);
  return {across * std::cos(turn), height, across * std::sin(turn)};
}

glm::vec3 any_unit() {
  const float height = any_float(-1.0F, 1.0F);
  return unit_at(height, any_float(0.0F, 6.2831853F));
}

/// Of any kind, outside the scene's sphere by at least the given factor.
light any_light(float nearest) {
  const light_kind kind = *rc::gen::element(light_kind::directional, light_kind::point, light_kind::spot);
  const glm::vec3 toward = any_unit();
  return {kind, any_float(nearest, 10.0F) * toward, -toward, any_vec3(0.0F, 3.0F), 0.9F, 0.95F};
}

sphere any_sphere() {
  const glm::vec3 centre = any_vec3(-5.0F, 5.0F);
  return {centre, any_float(0.1F, 10.0F)};
}

TEST_CASE("a light is read as it is written") {
  const light sun = parse_light("directional:0,2,0:1,0.5,0");
  CHECK(sun.kind == light_kind::directional);
  CHECK(sun.direction == glm::vec3(0.0F, -1.0F, 0.0F));
  CHECK(sun.colour == glm::vec3(1.0F, 0.5F, 0.0F));

  const light bulb = parse_light("point:0,0,-4:1e1,.5,3");
  CHECK(bulb.kind == light_kind::point);
  CHECK(bulb.position == glm::vec3(0.0F, 0.0F, -4.0F));
  CHECK(bulb.colour == glm::vec3(10.0F, 0.5F, 3.0F));

  const light lamp = parse_light("spot:3,0,0:1,1,1:90");
  CHECK(lamp.kind == light_kind::spot);
  CHECK(lamp.direction == glm::vec3(-1.0F, 0.0F, 0.0F));
  CHECK(lamp.cos_outer == doctest::Approx(std::sqrt(0.5)));
  CHECK(lamp.cos_inner > lamp.cos_outer);
}

TEST_CASE("a text that is no light is refused in one line that names it") {
  for (const std::string text : {"",
                                 ":",
                                 "sun:1,2,3:1,1,1",
                                 "Point:1,2,3:1,1,1",
                                 "point",
                                 "point:1,2,3",
                                 "point:1,2,3:1,1,1:",
                                 "point:1,2,3:1,1,1:9",
                                 "point:1,2:1,1,1",
                                 "point:1,2,3,4:1,1,1",
                                 "point:1,2,3,:1,1,1",
                                 "point:1,,3:1,1,1",
                                 "point:1,2,x:1,1,1",
                                 "point:1,2,3z:1,1,1",
                                 "point:1,2,nan:1,1,1",
                                 "point:1,2,inf:1,1,1",
                                 "point:1,2,1e99:1,1,1",
                                 "point:1,2,3:-1,1,1",
                                 "point:1,2,3:1,1",
                                 "point:0,0,0:1,1,1",
                                 "directional:0,0,0:1,1,1",
                                 "directional:3e38,3e38,0:1,1,1",
                                 "spot:1,2,3:1,1,1",
                                 "spot:1,2,3:1,1,1:0",
                                 "spot:1,2,3:1,1,1:-20",
                                 "spot:1,2,3:1,1,1:170",
                                 "spot:1,2,3:1,1,1:nan",
                                 "spot:1,2,3:1,1,1:60:60"}) {
    CAPTURE(text);
    try {
      static_cast<void>(parse_light(text));
      FAIL_CHECK("the text was accepted");
    } catch (const std::invalid_argument& error) {
      const std::string line = error.what();
      CHECK(line.starts_with("light '" + text + "': "));
      CHECK(line.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("a light's view holds the whole sphere of the fibres and little else") {
  holds("every point of the sphere", [] {
    const sphere round = any_sphere();
    const light placed = place_light(any_light(1.2F), round);
    const view v = light_view(placed, round, 100);
    float widest = 0.0F;
    for (int i = 0; i < 200; ++i) {
      const glm::vec3 on_unit = unit_at(static_cast<float>(i) / 100.0F - 0.995F, 2.4F * static_cast<float>(i));
      const glm::vec3 p = v.to_view(round.centre + round.radius * on_unit);
      const glm::vec2 off = glm::abs(v.to_pixel(p) - 50.0F);
      RC_ASSERT(std::max(off.x, off.y) < 49.5F);  // where all four texels round it are in the map
      RC_ASSERT(-p.z > v.near_plane);
      widest = std::max({widest, off.x, off.y});
    }
    RC_ASSERT(widest > 40.0F);
  });
}

TEST_CASE("a point or spot light inside the sphere has no view") {
  const sphere round{glm::vec3(1.0F, 2.0F, 3.0F), 4.0F};
  for (const std::string text : {"point:0.5,0,0:1,1,1", "spot:0,0,1:1,1,1:60"}) {
    CHECK_THROWS_AS(static_cast<void>(light_view(place_light(parse_light(text), round), round, 64)),
                    std::invalid_argument);
  }
  CHECK_NOTHROW(static_cast<void>(light_view(place_light(parse_light("directional:0.5,0,0:1,1,1"), round), round, 64)));
}

TEST_CASE("light has its colour at the scene's centre, and falls with the square of the distance") {
  holds("colour and fall", [] {
    const sphere round = any_sphere();
    const light placed = place_light(any_light(1.2F), round);
    const arrival centre = light_at(placed, round, round.centre);
    RC_ASSERT(glm::length(centre.colour - placed.colour) <= 1e-5F * glm::length(placed.colour));
    RC_ASSERT(glm::length(centre.to_light + placed.direction) < 1e-5F);

    const glm::vec3 half_way = 0.5F * (round.centre + placed.position);
    const float factor = placed.kind == light_kind::directional ? 1.0F : 4.0F;
    const arrival nearer = light_at(placed, round, half_way);
    RC_ASSERT(glm::length(nearer.colour - factor * placed.colour) <= 1e-4F * glm::length(placed.colour));

    const arrival at = light_at(placed, round, round.centre + round.radius * any_unit());
    RC_ASSERT(std::abs(glm::length(at.to_light) - 1.0F) < 1e-5F);
    const arrival within = light_at(placed, round, placed.position);
    RC_ASSERT(std::isfinite(glm::length(within.to_light) + within.colour.r + within.colour.g + within.colour.b));
  });
}

TEST_CASE("a spot fades from its inner to its outer edge without a step") {
  holds("smooth edges", [] {
    const float degrees = any_float(5.0F, 169.0F);
    const sphere round{glm::vec3(0.0F), 1.0F};
    const light spot = place_light(parse_light("spot:0,0,3:1,1,1:" + std::to_string(degrees)), round);
    constexpr int steps = 2000;
    float before = 1.0F;
    for (int i = 0; i <= steps; ++i) {
      const float angle = glm::radians(0.6F * degrees) * static_cast<float>(i) / steps;
      const glm::vec3 at = spot.position + 3.0F * glm::vec3(std::sin(angle), 0.0F, -std::cos(angle));
      const float strength = light_at(spot, round, at).colour.r;
      RC_ASSERT(strength <= before + 1e-4F);
      RC_ASSERT(before - strength < 0.02F);
      if (angle < 0.99F * glm::radians(0.4F * degrees)) RC_ASSERT(std::abs(strength - 1.0F) < 1e-3F);
      if (angle > 1.01F * glm::radians(0.5F * degrees)) RC_ASSERT(strength == 0.0F);
      before = strength;
    }
  });
}

}  // namespace pelage::test
