// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/alpha_layers.hpp>

#include "composite/layers.hpp"
#include "property.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace pelage::test {

struct placed {
  fragment where;
  layer what;
};

/// Some of them at one depth.
std::vector<placed> draw_placed() {
  std::vector<placed> all;
  for (const layer& each : draw_layers()) {
    const auto depth = static_cast<float>(*rc::gen::inRange(0, 40));
    all.push_back({fragment{depth, static_cast<std::uint32_t>(all.size())}, each});
  }
  std::shuffle(all.begin(), all.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
  return all;
}

bool nearer(const placed& a, const placed& b) {
  return before(a.where, b.where);
}

template <std::uint32_t N>
alpha_layers<N> layers_of(const std::vector<placed>& all) {
  auto layers = alpha_layers<N>::empty();
  for (const placed& each : all) {
    layers.insert(each.where, each.what.alpha, each.what.colour);
  }
  return layers;
}

struct composited {
  fragment nearest;
  double transmittance;
  glm::dvec3 radiance;
};

/// The paper's text: insert, sort, and merge the two last of more than `most`.
std::vector<composited> as_the_paper(const std::vector<placed>& arriving, std::size_t most) {
  std::vector<composited> all;
  for (const placed& each : arriving) {
    if (each.what.alpha == 0.0f) continue;
    const double alpha = each.what.alpha;
    all.push_back({each.where, 1.0 - alpha, alpha * glm::dvec3(each.what.colour)});
    std::sort(all.begin(), all.end(),
              [](const composited& a, const composited& b) { return before(a.nearest, b.nearest); });
    if (all.size() > most) {
      const composited last = all.back();
      all.pop_back();
      all.back().radiance += all.back().transmittance * last.radiance;
      all.back().transmittance *= last.transmittance;
    }
  }
  return all;
}

glm::dvec3 seen(const std::vector<composited>& all, const glm::dvec3& background) {
  glm::dvec3 sum(0.0);
  double passed = 1.0;
  for (const composited& each : all) {
    sum += passed * each.radiance;
    passed *= each.transmittance;
  }
  return sum + passed * background;
}

constexpr std::size_t unlimited = 1000;

TEST_CASE("each arrival leaves the layers that the paper's text leaves") {
  holds("1 and 4 layers", [] {
    const std::vector<placed> all = draw_placed();
    const glm::vec3 background = draw_colour();
    RC_ASSERT(glm::length(glm::dvec3(layers_of<1>(all).resolve(background)) -
                          seen(as_the_paper(all, 1), glm::dvec3(background))) < 1e-5);
    const auto four = layers_of<4>(all);
    const auto expected = as_the_paper(all, 4);
    for (std::size_t i = 0; i < 4u; ++i) {
      if (i < expected.size()) {
        RC_ASSERT(same(four.layer[i].nearest, expected[i].nearest));
        RC_ASSERT(std::abs(double{four.layer[i].transmittance} - expected[i].transmittance) < 1e-5);
        RC_ASSERT(glm::length(glm::dvec3(four.layer[i].radiance) - expected[i].radiance) < 1e-5);
      } else {
        RC_ASSERT(!is_fragment(four.layer[i].nearest));
        RC_ASSERT(four.layer[i].transmittance == 1.0f);
      }
    }
  });
}

TEST_CASE("as many fragments as layers have the same bits in any order, and are sorted") {
  holds("up to 32", [] {
    std::vector<placed> all = draw_placed();
    const glm::vec3 background = draw_colour();
    const auto some = layers_of<32>(all);
    RC_ASSERT(glm::length(glm::dvec3(some.resolve(background)) -
                          seen(as_the_paper(all, unlimited), glm::dvec3(background))) < 1e-5);
    std::shuffle(all.begin(), all.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    const auto others = layers_of<32>(all);
    RC_ASSERT(std::memcmp(&some, &others, sizeof(some)) == 0);
  });
}

TEST_CASE("fragments that come by depth, from either end, are sorted whatever the number of layers") {
  holds("2 layers", [] {
    std::vector<placed> all = draw_placed();
    const glm::vec3 background = draw_colour();
    const glm::dvec3 truth = seen(as_the_paper(all, unlimited), glm::dvec3(background));
    std::sort(all.begin(), all.end(), nearer);
    RC_ASSERT(glm::length(glm::dvec3(layers_of<2>(all).resolve(background)) - truth) < 1e-5);
    std::reverse(all.begin(), all.end());
    RC_ASSERT(glm::length(glm::dvec3(layers_of<2>(all).resolve(background)) - truth) < 1e-5);
  });
}

TEST_CASE("what passes is the product, and what is seen is within the hull of colours, in any order") {
  holds("3 layers", [] {
    const std::vector<placed> all = draw_placed();
    const auto layers = layers_of<3>(all);
    double product = 1.0;
    for (const placed& each : all) {
      product *= 1.0 - double{each.what.alpha};
    }
    RC_ASSERT(std::abs(double{layers.transmittance()} - product) < 1e-5);
    RC_ASSERT(glm::length(layers.resolve(glm::vec3(1.0f)) - glm::vec3(1.0f)) <= 1.8f);
    std::vector<placed> white = all;
    for (placed& each : white) {
      each.what.colour = glm::vec3(1.0f);
    }
    RC_ASSERT(glm::length(layers_of<3>(white).resolve(glm::vec3(1.0f)) - glm::vec3(1.0f)) < 1e-5f);
  });
}

TEST_CASE("what is no fragment, and what is not seen, changes nothing") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto layers = alpha_layers<2>::empty();
  layers.insert({2.0f, 7u}, 0.5f, glm::vec3(1.0f));
  const auto before_them = layers;
  layers.insert({nan, 1u}, 0.5f, glm::vec3(1.0f));
  layers.insert(no_fragment(), 0.5f, glm::vec3(1.0f));
  layers.insert({1.0f, 1u}, 0.0f, glm::vec3(1.0f));
  layers.insert({1.0f, 2u}, -1.0f, glm::vec3(1.0f));
  layers.insert({1.0f, 3u}, nan, glm::vec3(1.0f));
  CHECK(std::memcmp(&layers, &before_them, sizeof(layers)) == 0);
  CHECK(alpha_layers<2>::empty().resolve(glm::vec3(0.25f)) == glm::vec3(0.25f));
}

TEST_CASE("an opaque fragment hides what comes before or after it and lies behind it") {
  auto layers = alpha_layers<1>::empty();
  layers.insert({3.0f, 0u}, 0.5f, glm::vec3(0.0f, 1.0f, 0.0f));
  layers.insert({2.0f, 1u}, 7.0f, glm::vec3(1.0f, 0.0f, 0.0f));
  layers.insert({4.0f, 2u}, 0.5f, glm::vec3(0.0f, 0.0f, 1.0f));
  CHECK(layers.resolve(glm::vec3(1.0f)) == glm::vec3(1.0f, 0.0f, 0.0f));
}

}  // namespace pelage::test
