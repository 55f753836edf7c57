// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/subjects.hpp"

#include <cmath>

#include "frame/base/random.hpp"
#include "frame/model/built_in.hpp"
#include "frame/stage.hpp"

namespace pelage::truth {
namespace {

constexpr float pi = 3.14159265F;

void add_strand(frame::hair_model& model, const std::vector<glm::vec3>& points) {
  model.points.insert(model.points.end(), points.begin(), points.end());
  model.first_point.push_back(static_cast<std::uint32_t>(model.points.size()));
}

glm::vec3 around(float angle, float radius, float z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

}  // namespace

subject built_in(std::uint32_t strands, std::uint32_t segments, int size, int samples) {
  subject s{frame::make_built_in(strands, segments, 1), {}, samples};
  s.settings.width = s.settings.height = size;
  s.settings.on_bust = true;
  return s;
}

subject ball_before_hair(int size, int samples) {
  constexpr int strands = 8000;
  constexpr int segments = 12;
  constexpr float radius = 0.5F;
  subject s{{}, {}, samples};
  s.model.default_thickness = 0.003F;
  for (int i = 0; i < strands; ++i) {
    frame::random_stream random(7, static_cast<std::uint64_t>(i));
    const float back = random.between(0.6F, 1.0F);
    std::vector<glm::vec3> points{radius *
                                  around(random.between(0.0F, 2.0F * pi), std::sqrt(1.0F - back * back), -back)};
    const glm::vec3 from =
        around(random.between(0.0F, 2.0F * pi), 0.4F * std::sqrt(random.unit()), random.between(-0.9F, -0.6F));
    const glm::vec3 way = around(random.between(0.0F, 2.0F * pi), 0.9F, random.between(-0.1F, 0.0F));
    for (int k = 0; k < segments; ++k)
      points.push_back(from + static_cast<float>(k) / static_cast<float>(segments - 1) * way);
    add_strand(s.model, points);
  }
  s.settings.width = s.settings.height = size;
  s.settings.from = glm::vec2(0.0F, 0.0F);
  return s;
}

subject lone_fibres(double radius, int samples) {
  subject s{{}, {}, samples};
  s.settings.width = s.settings.height = 160;
  s.settings.from = glm::vec2(0.0F, 0.0F);
  for (int i = 0; i < lone_fibres_count; ++i) {
    const float x = 2.0F * static_cast<float>(i) / static_cast<float>(lone_fibres_count - 1) - 1.0F;
    add_strand(s.model, {{x, -0.1F, 0.0F}, {x, 0.0F, 0.0F}, {x, 0.1F, 0.0F}});
  }
  const frame::view eye = frame::set_up(s.model, s.settings).eye;
  s.settings.fibre_radius = static_cast<float>(radius) * std::abs(eye.eye.z) / eye.scale;
  return s;
}

}  // namespace pelage::truth
