// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/radiance.hpp>

#include "composite/layers.hpp"
#include "property.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace pelage::test {

struct lit_fibre {
  glm::vec3 scattered, attenuation;
  float coverage;
};

std::vector<lit_fibre> draw_fibres() {
  std::vector<lit_fibre> fibres(*rc::gen::inRange<std::size_t>(0u, 60u));
  for (lit_fibre& each : fibres) {
    each.scattered = draw_colour();
    each.attenuation = draw_colour();
    each.coverage = draw_share();
  }
  return fibres;
}

pixel_radiance<float> gathered(const std::vector<lit_fibre>& fibres) {
  pixel_radiance<float> pixel = empty_pixel<float>();
  for (const lit_fibre& each : fibres) {
    pixel = add_fibre(pixel, each.scattered, each.attenuation, each.coverage);
  }
  return pixel;
}

/// The product of transmittances of the first `count` fibres, in double.
glm::dvec3 passed_by(const std::vector<lit_fibre>& fibres, std::size_t count) {
  glm::dvec3 passed(1.0);
  for (std::size_t j = 0u; j < count; ++j) {
    const double coverage = fibres[j].coverage;
    passed *= glm::dvec3(fibres[j].attenuation) * coverage + (1.0 - coverage);
  }
  return passed;
}

TEST_CASE("an empty pixel shows the background") {
  CHECK(resolve(empty_pixel<float>(), glm::vec3(0.1f, 0.2f, 0.3f)) == glm::vec3(0.1f, 0.2f, 0.3f));
}

TEST_CASE("fibres added front to back give the sum of Yu12 Eq. 5, each weighed by what it stops") {
  holds("each by what passes those before it, in double", [] {
    const std::vector<lit_fibre> fibres = draw_fibres();
    const glm::vec3 background = draw_colour();
    const std::size_t count = fibres.size();
    glm::dvec3 sum = passed_by(fibres, count) * glm::dvec3(background);
    for (std::size_t i = 0u; i < count; ++i) {
      const glm::dvec3 stopped = (1.0 - glm::dvec3(fibres[i].attenuation)) * static_cast<double>(fibres[i].coverage);
      sum += stopped * glm::dvec3(fibres[i].scattered) * passed_by(fibres, i);
    }
    RC_ASSERT(glm::length(glm::dvec3(resolve(gathered(fibres), background)) - sum) < 2e-6);
  });
}

TEST_CASE("Yu §5.1: behind 16 fibres that stop a quarter 1.002 % is left, and 16 that stop a fifth hold 97.19 %") {
  const auto passed = [](float stopped) {
    return gathered(std::vector<lit_fibre>(16u, {glm::vec3(1.0f), glm::vec3(1.0f - stopped), 1.0f}));
  };
  CHECK(passed(0.25f).transmittance.x == doctest::Approx(0.01002259575761855).epsilon(1e-6));
  CHECK(passed(0.2f).radiance.x == doctest::Approx(0.97185250232894463).epsilon(1e-6));
}

TEST_CASE("Yu Eq. 3 and 5: a half covered, reddish fibre before another, worked out by hand") {
  // The first passes A C + 1 - C = (0.9, 0.75, 0.5) and stops (0.1, 0.25, 0.5), the second passes 1/4 and stops 3/4.
  const std::vector<lit_fibre> two{{{1.0f, 2.0f, 4.0f}, {0.8f, 0.5f, 0.0f}, 0.5f},
                                   {glm::vec3(4.0f), glm::vec3(0.25f), 1.0f}};
  const glm::dvec3 expected(0.1 + 0.9 * 3.0 + 0.9 * 0.25, 0.5 + 0.75 * 3.0 + 0.75 * 0.25, 2.0 + 0.5 * 3.0 + 0.5 * 0.25);
  CHECK(glm::length(glm::dvec3(resolve(gathered(two), glm::vec3(1.0f))) - expected) < 1e-6);
}

TEST_CASE("a tail stands behind the fibres as one layer of its mean colour, before the background") {
  holds("sum in double", [] {
    const pixel_radiance<float> pixel = gathered(draw_fibres());
    tail behind = empty_tail();
    for (const layer& each : draw_layers(0.9f)) {
      behind = add_fragment(behind, each.alpha, each.colour);
    }
    const glm::vec3 background = draw_colour();
    const double passed = transmittance_of(behind);
    const glm::dvec3 layer = (1.0 - passed) * glm::dvec3(mean_colour(behind)) + passed * glm::dvec3(background);
    const glm::dvec3 expected = glm::dvec3(pixel.radiance) + glm::dvec3(pixel.transmittance) * layer;
    RC_ASSERT(glm::length(glm::dvec3(resolve(add_tail(pixel, behind), background)) - expected) < 1e-6);
  });
}

TEST_CASE("in a white furnace the pixel is white") {
  holds("whatever lies in it", [] {
    std::vector<lit_fibre> fibres = draw_fibres();
    for (lit_fibre& each : fibres) {
      each.scattered = glm::vec3(1.0f);
    }
    const tail behind = add_fragment(empty_tail(), draw_share(), glm::vec3(1.0f));
    const pixel_radiance<float> pixel = gathered(fibres);
    RC_ASSERT(glm::length(resolve(pixel, glm::vec3(1.0f)) - glm::vec3(1.0f)) < 2e-6f);
    RC_PRE(behind.weight > 0u || transmittance_of(behind) == 1.0f);
    RC_ASSERT(glm::length(resolve(add_tail(pixel, behind), glm::vec3(1.0f)) - glm::vec3(1.0f)) < 2e-6f);
  });
}

TEST_CASE("the transmittance is the fibres' product") {
  holds("in double", [] {
    const std::vector<lit_fibre> fibres = draw_fibres();
    const glm::dvec3 passed = passed_by(fibres, fibres.size());
    RC_ASSERT(glm::length(glm::dvec3(gathered(fibres).transmittance) - passed) < 2e-6);
  });
}

}  // namespace pelage::test
