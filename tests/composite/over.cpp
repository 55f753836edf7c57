// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/over.hpp>

#include "composite/layers.hpp"
#include "property.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace pelage::test {

static_assert(over(glm::vec4(0.25f), glm::vec4(1.0f)) == glm::vec4(1.0f));

glm::vec4 draw_layer() {
  const glm::vec3 colour = draw_colour();
  return premultiply(colour, draw_share());
}

float distance(const glm::vec4& a, const glm::vec4& b) {
  return glm::length(a - b);
}

TEST_CASE("premultiply scales the colour by alpha and keeps alpha") {
  holds("channel by channel", [] {
    const glm::vec3 colour = draw_colour();
    const float alpha = draw_share();
    RC_ASSERT(premultiply(colour, alpha) == glm::vec4(colour.x * alpha, colour.y * alpha, colour.z * alpha, alpha));
  });
}

TEST_CASE("over is associative except for rounding") {
  holds("within 4 ulp of white", [] {
    const glm::vec4 a = draw_layer();
    const glm::vec4 b = draw_layer();
    const glm::vec4 c = draw_layer();
    RC_ASSERT(distance(over(over(a, b), c), over(a, over(b, c))) < 5e-7f);
  });
}

TEST_CASE("a transparent black is the identity on both sides, bit for bit") {
  holds("layer", [] {
    const glm::vec4 layer = draw_layer();
    RC_ASSERT(over(layer, glm::vec4(0.0f)) == layer);
    RC_ASSERT(over(glm::vec4(0.0f), layer) == layer);
  });
}

TEST_CASE("an opaque front hides any finite back") {
  holds("front only", [] {
    const glm::vec4 front = premultiply(draw_colour(), 1.0f);
    RC_ASSERT(over(front, 1e30f * draw_layer()) == front);
  });
}

TEST_CASE("layers one over the other are the sum of each by what passes those before it") {
  holds("naive sum in double", [] {
    const std::size_t count = *rc::gen::inRange<std::size_t>(0u, 40u);
    std::vector<glm::vec4> layers;
    glm::vec4 seen(0.0f);
    for (std::size_t i = 0u; i < count; ++i) {
      layers.push_back(draw_layer());
      seen = over(seen, layers.back());
    }
    glm::dvec4 sum(0.0);
    for (std::size_t i = 0u; i < count; ++i) {
      double passed = 1.0;
      for (std::size_t j = 0u; j < i; ++j) {
        passed *= 1.0 - layers[j].w;
      }
      sum += passed * glm::dvec4(layers[i]);
    }
    RC_ASSERT(distance(seen, glm::vec4(sum)) < 1e-6f);
  });
}

}  // namespace pelage::test
