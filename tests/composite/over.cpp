// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/over.hpp>

#include "composite/layers.hpp"
#include "property.hpp"

#include <glm/common.hpp>
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

void check_near(const glm::vec4& found, const glm::vec4& expected) {
  CAPTURE(found.x);
  CAPTURE(found.y);
  CAPTURE(found.z);
  CAPTURE(found.w);
  CHECK(distance(found, expected) < 3e-7f);
}

TEST_CASE("Svoboda §2.5.2: light thrice as bright as white survives in a premultiplied colour") {
  const glm::vec3 lit = 3.0f * glm::vec3(0.8f, 0.7f, 0.4f);
  const glm::vec4 kept = premultiply(lit, 0.3f);
  check_near(kept, {0.72f, 0.63f, 0.36f, 0.3f});
  check_near(premultiply(glm::min(lit, glm::vec3(1.0f)), 0.3f),
             {0.3f, 0.3f, 0.3f, 0.3f});                                                    // what clamping first leaves
  check_near(over(kept, glm::vec4(0.5f, 0.5f, 0.5f, 1.0f)), {1.07f, 0.98f, 0.71f, 1.0f});  // C + B (1 - A)
}

TEST_CASE("Svoboda §2.5.3: of two lights the alpha counts once, (C1 + C2) A + B (1 - A)") {
  const glm::vec3 key(0.5f, 0.25f, 0.0f);
  const glm::vec3 rim(0.25f, 0.25f, 0.5f);
  check_near(over(premultiply(key + rim, 0.4f), glm::vec4(1.0f)), {0.9f, 0.8f, 0.8f, 1.0f});
}

TEST_CASE("Svoboda §1.3.3: two fibres in the wrong order are off by (C1 - C2) A²") {
  const glm::vec4 near = premultiply(glm::vec3(1.0f, 0.8f, 0.6f), 0.5f);
  const glm::vec4 far = premultiply(glm::vec3(0.8f, 0.6f, 0.4f), 0.5f);
  const glm::vec4 background(0.2f, 0.2f, 0.8f, 1.0f);
  check_near(over(near, over(far, background)), {0.75f, 0.6f, 0.6f, 1.0f});
  check_near(over(far, over(near, background)), {0.7f, 0.55f, 0.55f, 1.0f});
  check_near(over(near, background), {0.6f, 0.5f, 0.7f, 1.0f});  // with depth writes the far one is lost
  holds("any colours", [] {
    const glm::vec3 c1 = draw_colour();
    const glm::vec3 c2 = draw_colour();
    const float alpha = draw_share();
    const glm::vec4 a = premultiply(c1, alpha);
    const glm::vec4 b = premultiply(c2, alpha);
    const glm::vec4 expected((c1 - c2) * alpha * alpha, 0.0f);
    RC_ASSERT(distance(over(a, b) - over(b, a), expected) < 5e-7f);
  });
}

}  // namespace pelage::test
