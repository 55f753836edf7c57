// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang.hpp>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace pelage::bench {

/// Thousands of fibres, places on them and pairs of directions, all different, so that no branch and no value can be
/// learnt: h, η, σ_a, both roughnesses and the tilt even over what hair has, directions even over the sphere.
struct configurations {
  explicit configurations(std::size_t count) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> draw(0.0f, 1.0f);
    const auto direction = [&] {
      const float x = 2.0f * draw(generator) - 1.0f;
      const float phi = 2.0f * std::numbers::pi_v<float> * draw(generator);
      const float across = std::sqrt((1.0f - x) * (1.0f + x));
      return glm::vec3(x, across * std::cos(phi), across * std::sin(phi));
    };
    for (std::size_t k = 0; k < count; ++k) {
      h.push_back(2.0f * draw(generator) - 1.0f);
      const float eta = 1.3f + 0.5f * draw(generator);
      const std::array<float, 3> sigma = {3.0f * draw(generator), 3.0f * draw(generator), 3.0f * draw(generator)};
      const float beta_m = 0.05f + 0.95f * draw(generator);
      const float beta_n = 0.05f + 0.95f * draw(generator);
      parameters.push_back({eta, sigma, beta_m, beta_n, 0.17f * draw(generator) - 0.085f});
      eye.push_back(direction());
      light.push_back(direction());
      u.push_back(glm::vec4(draw(generator), draw(generator), draw(generator), draw(generator)));
    }
  }

  [[nodiscard]] std::size_t size() const { return h.size(); }

  std::vector<float> h;
  std::vector<chiang_parameters<float>> parameters;
  std::vector<glm::vec3> eye, light;
  std::vector<glm::vec4> u;
};

}  // namespace pelage::bench
