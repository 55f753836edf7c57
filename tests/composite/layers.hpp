// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>
#include <rapidcheck.h>

#include <cstddef>
#include <vector>

/// What the tests of composite/ draw: shares, colours and piles of layers.
namespace pelage::test {

/// A number in [0, 1], often an end.
inline float draw_share() {
  const int steps = 1 << 24;
  return static_cast<float>(*rc::gen::oneOf(rc::gen::element(0, 1, steps - 1, steps),
                                            rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, steps + 1)))) /
         static_cast<float>(steps);
}

inline glm::vec3 draw_colour() {
  const float red = draw_share();
  const float green = draw_share();
  return glm::vec3(red, green, draw_share());
}

struct layer {
  float alpha;
  glm::vec3 colour;
};

/// From 0 to 30 layers, no alpha above this.
inline std::vector<layer> draw_layers(float most_alpha = 1.0f) {
  std::vector<layer> layers(*rc::gen::inRange<std::size_t>(0u, 31u));
  for (layer& each : layers) {
    each.alpha = most_alpha * draw_share();
    each.colour = draw_colour();
  }
  return layers;
}

}  // namespace pelage::test
