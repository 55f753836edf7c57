// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/atomic_tail.hpp>
#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/weighted_average.hpp>
#include <pelage/composite/weighted_blended.hpp>
#include <pelage/composite/weighted_sum.hpp>

#include "composite/layers.hpp"
#include "property.hpp"
#include "visibility/cells.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace pelage::test {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::array<std::uint32_t, 5> bits(const tail& t) {
  return std::bit_cast<std::array<std::uint32_t, 5>>(t);
}

std::array<std::uint32_t, 6> bits(const weighted_average& a) {
  return std::bit_cast<std::array<std::uint32_t, 6>>(a);
}

/// What is seen of layers in their order, nearest first: the truth.
glm::dvec3 sorted_over(const std::vector<layer>& layers, const glm::vec3& background) {
  glm::dvec3 colour(0.0);
  double passed = 1.0;
  for (const layer& each : layers) {
    colour += passed * each.alpha * glm::dvec3(each.colour);
    passed *= 1.0 - each.alpha;
  }
  return colour + passed * glm::dvec3(background);
}

double distance(const glm::vec3& a, const glm::dvec3& b) {
  return glm::length(glm::dvec3(a) - b);
}

/// Layers of one alpha, as the papers' figures have them.
std::vector<layer> draw_equal_layers(float alpha) {
  std::vector<layer> layers = draw_layers();
  for (layer& each : layers) {
    each.alpha = alpha;
  }
  return layers;
}

tail order_weighted_sum(const std::vector<layer>& layers) {
  tail sum = empty_tail();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const float weight = order_weight(layers[i].alpha, static_cast<float>(i));
    sum = add_weighted(sum, layers[i].alpha, weight, layers[i].colour);
  }
  return sum;
}

TEST_CASE("order-weighted blending is sorted blending where all alphas are equal and all orders right") {
  holds("any colours", [] {
    const std::vector<layer> layers = draw_equal_layers(*rc::gen::element(0.03f, 0.15f, 0.25f, 0.5f, 0.9f));
    const glm::vec3 background = draw_colour();
    RC_ASSERT(distance(resolve(order_weighted_sum(layers), background), sorted_over(layers, background)) < 1e-4);
  });
}

TEST_CASE("Sintorn & Assarsson §3.4: three fragments of alpha one half, worked out by hand") {
  const std::vector<layer> layers{{0.5f, {1, 0, 0}}, {0.5f, {0, 1, 0}}, {0.5f, {0, 0, 1}}};
  const glm::vec3 background(0.8f);  // (1 - α)³ of it is 0.1
  CHECK(distance(resolve(order_weighted_sum(layers), background), {0.6, 0.35, 0.225}) < 1e-6);
}

TEST_CASE("where orders are wrong, Λ over the sum of the weights restores what the fibres cover, not its inverse") {
  tail sum = empty_tail();
  const float order[] = {0.0f, 1.0f, 3.0f};  // the last should be 2: weights ½ + ¼ + 1/16 = 13/16, Λ = 7/8
  for (int i = 0; i < 3; ++i) {
    glm::vec3 colour(0.0f);
    colour[i] = 1.0f;
    sum = add_weighted(sum, 0.5f, order_weight(0.5f, order[i]), colour);
  }
  const glm::vec3 seen = resolve(sum, glm::vec3(0.0f));
  CHECK(distance(seen, glm::dvec3(8.0, 4.0, 1.0) / 16.0 * (14.0 / 13.0)) < 1e-6);
  CHECK(std::abs(seen.x + seen.y + seen.z - 0.875) < 1e-6);
}

TEST_CASE("a weight by optical depth is right where alphas differ too") {
  holds("any layers", [] {
    const std::vector<layer> layers = draw_layers(0.9f);
    const glm::vec3 background = draw_colour();
    tail sum = empty_tail();
    float passed_optical = 0.0f;
    for (const layer& each : layers) {
      sum = add_weighted(sum, each.alpha, optical_weight(each.alpha, passed_optical), each.colour);
      passed_optical += static_cast<float>(optical_depth(each.alpha));
    }
    // Weights round by 2^-21 each, and where alphas are tiny that is much of their sum.
    double weight = 0.0;
    for (const layer& each : layers) {
      weight += each.alpha;
    }
    RC_PRE(weight == 0.0 || weight > 0.01);
    RC_ASSERT(distance(resolve(sum, background), sorted_over(layers, background)) < 3e-3);
  });
}

TEST_CASE("a pixel of one colour keeps it under every weight, its background shines through by the exact product") {
  holds("any weights", [] {
    const std::vector<layer> layers = draw_layers();
    const glm::vec3 colour = draw_colour();
    tail sum = empty_tail();
    double passed = 1.0;
    bool weighed = false;
    for (const layer& each : layers) {
      const float weight = draw_share();
      weighed = weighed || weight > 0.01f;
      sum = add_weighted(sum, each.alpha, weight, colour);
      passed *= 1.0 - each.alpha;
    }
    RC_PRE(weighed);
    const glm::vec3 background = draw_colour();
    const glm::dvec3 expected = (1.0 - passed) * glm::dvec3(colour) + passed * glm::dvec3(background);
    RC_ASSERT(distance(resolve(sum, background), expected) < 1e-3);
  });
}

TEST_CASE("threads leave the bits of the plain sum in their pixel and nothing in another") {
  holds("1 to 8 threads", [] {
    const std::vector<layer> layers = draw_layers();
    const tail expected = order_weighted_sum(layers);
    for (std::uint32_t threads = 1u; threads <= 8u; threads *= 2u) {
      cells_of<shaken_cells> storage(3u * tail_words(), 0u);
      deal_to_threads(threads, layers.size(), [&](std::size_t i) {
        const float weight = order_weight(layers[i].alpha, static_cast<float>(i));
        atomic_tail::add(storage, 1u, add_weighted(empty_tail(), layers[i].alpha, weight, layers[i].colour));
      });
      RC_ASSERT(bits(atomic_tail::load(storage, 1u)) == bits(expected));
      RC_ASSERT(bits(atomic_tail::load(storage, 0u)) == bits(empty_tail()));
      RC_ASSERT(bits(atomic_tail::load(storage, 2u)) == bits(empty_tail()));
    }
  });
}

TEST_CASE("a weight of order falls with the order, an opaque fragment hides all behind it") {
  holds("two orders", [] {
    const float alpha = draw_share();
    const float a = 30.0f * draw_share();
    const float b = 30.0f * draw_share();
    RC_ASSERT(order_weight(alpha, std::max(a, b)) <= order_weight(alpha, std::min(a, b)) * 1.000001f);
    RC_ASSERT(order_weight(alpha, 0.0f) == alpha);
    RC_ASSERT(std::abs(order_weight(alpha, a) - alpha * std::pow(1.0 - alpha, double{a})) < 2e-6);
  });
  CHECK(order_weight(1.0f, 0.0f) == 1.0f);
  CHECK(order_weight(1.0f, 1e-6f) == 0.0f);
  CHECK(optical_weight(0.5f, 1048576.0f) == 0.25f);
}

TEST_CASE("unscaled, a sum is its weights times colours, and the background by the exact product") {
  holds("any layers, any weights", [] {
    const std::vector<layer> layers = draw_layers();
    const glm::vec3 background(0.25f, 0.5f, 1.0f);
    tail sum = empty_tail();
    glm::dvec3 expected(0.0);
    double passed = 1.0;
    for (const layer& each : layers) {
      const float weight = static_cast<float>(*rc::gen::inRange(0, 1001)) / 1000.0f;
      sum = add_weighted(sum, each.alpha, weight, each.colour);
      expected += static_cast<double>(weight) * glm::dvec3(each.colour);
      passed *= 1.0 - static_cast<double>(each.alpha);
    }
    expected += passed * glm::dvec3(background);
    RC_ASSERT(distance(resolve_unscaled(sum, background), expected) < 1e-5 * (1.0 + glm::length(expected)));
  });
  CHECK(resolve_unscaled(empty_tail(), glm::vec3(0.25f)) == glm::vec3(0.25f));
}

TEST_CASE("weights that are none count as none") {
  for (const float weight : {nan, -1.0f, 0.0f}) {
    const tail t = add_weighted(empty_tail(), 0.5f, weight, glm::vec3(1.0f));
    CHECK(t.weight == 0u);
    CHECK(t.red == 0u);
    CHECK(transmittance_of(t) == 0.5f);
    CHECK(resolve(t, glm::vec3(1.0f)) == glm::vec3(0.5f));
  }
}

TEST_CASE("no brightness changes the hue of a weighted sum") {
  tail sum = empty_tail();
  for (int i = 0; i < 16; ++i) {
    sum = add_weighted(sum, 0.3f, 0.3f, glm::vec3(1e4f, 5e3f, 1.25e3f));
  }
  const glm::vec3 seen = resolve(sum, glm::vec3(0.0f));
  CHECK(glm::length(seen / seen.x - glm::vec3(1.0f, 0.5f, 0.125f)) < 1e-5f);
}

TEST_CASE("weights by distance keep a pixel's colour wherever in the scene's range it lies") {
  holds("weighted mean in double", [] {
    const float halvings = 8.0f * draw_share();
    const float place = draw_share();
    const float least_alpha = *rc::gen::element(0.01f, 0.05f, 0.5f);
    tail sum = empty_tail();
    glm::dvec3 colour(0.0);
    double weight = 0.0;
    for (const layer& each : draw_layers()) {
      const float alpha = std::max(each.alpha, least_alpha);
      const float z = std::min(place + 0.02f * draw_share(), 1.0f);
      sum = add_weighted(sum, alpha, distance_weight(alpha, z, halvings), each.colour);
      const double expected = double{alpha} * std::exp2(double{-halvings} * z);
      colour += expected * glm::dvec3(each.colour);
      weight += expected;
    }
    RC_PRE(weight > 0.0);
    RC_ASSERT(distance(mean_colour(sum), colour / weight) <=
              std::sqrt(3.0) * std::exp2(halvings - 20.0) / least_alpha + 2e-6);
  });
}

TEST_CASE("weights by distance fall from alpha, by half as often as told") {
  CHECK(distance_weight(0.5f, 0.0f, 6.0f) == 0.5f);
  CHECK(distance_weight(0.5f, 0.5f, 6.0f) == 0.0625f);
  CHECK(distance_weight(2.0f, 9.0f, 6.0f) == 0.015625f);
  CHECK(distance_weight(0.5f, nan, 6.0f) == 0.5f);
  CHECK(distance_weight(0.5f, 0.7f, 0.0f) == 0.5f);
  CHECK(distance_weight(nan, 0.5f, 6.0f) == 0.0f);
}

TEST_CASE("weighted average is sorted blending where all fragments are the same") {
  holds("any number", [] {
    const auto count = *rc::gen::inRange<std::size_t>(0u, 60u);
    const float alpha = 0.01f + 0.8f * draw_share();
    const std::vector<layer> layers(count, layer{alpha, draw_colour()});
    const glm::vec3 background = draw_colour();
    weighted_average average = weighted_average::empty();
    for (const layer& each : layers) {
      average.add(each.alpha, each.colour);
    }
    RC_ASSERT(distance(average.resolve(background), sorted_over(layers, background)) < 1e-3);
  });
}

TEST_CASE("Sintorn & Assarsson §2.2: mean alpha and alpha-weighted mean colour, worked out by hand") {
  weighted_average average = weighted_average::empty();
  average.add(0.5f, glm::vec3(1, 0, 0));
  average.add(0.25f, glm::vec3(0, 0, 1));
  // Mean alpha 3/8, mean colour (2/3, 0, 1/3), and (5/8)² = 25/64 passes.
  CHECK(distance(average.resolve(glm::vec3(0.0f)), {0.40625, 0.0, 0.203125}) < 2e-6);
  CHECK(distance(average.resolve(glm::vec3(0.64f)), {0.65625, 0.25, 0.453125}) < 2e-6);
}

/// Up to 2¹⁶ alphas, from 2⁻²⁴ on, alike or not; where they are alike, rounding to units of 2⁻²⁰ adds up.
std::vector<float> draw_alphas() {
  std::vector<float> alphas(static_cast<std::size_t>(std::exp2(0.01 * *rc::gen::inRange(0, 1601))));
  const float mean = std::exp2(-0.01f * static_cast<float>(*rc::gen::inRange(0, 2401)));
  const bool alike = *rc::gen::arbitrary<bool>();
  std::minstd_rand random(*rc::gen::arbitrary<std::uint32_t>());
  std::uniform_real_distribution<float> share;
  for (float& alpha : alphas) {
    alpha = alike ? mean : std::min(1.0f, 2.0f * mean * share(random));
  }
  return alphas;
}

TEST_CASE("the average's transmittance is the mean's power, and not less than the product, within 6e-7 a fragment") {
  holds("any alphas", [] {
    const std::vector<float> alphas = draw_alphas();
    weighted_average average = weighted_average::empty();
    double passed = 1.0;
    double sum = 0.0;
    for (const float alpha : alphas) {
      average.add(alpha, glm::vec3(1.0f));
      passed *= 1.0 - double{alpha};
      sum += double{alpha};
    }
    RC_PRE(sum < 4096.0);
    const auto n = static_cast<double>(alphas.size());
    const double found = average.transmittance();
    RC_LOG() << n << " " << sum << " " << found << " " << passed;
    RC_ASSERT(std::abs(found - std::pow(1.0 - sum / n, n)) <= 6e-7 * n);
    RC_ASSERT(found >= passed - 6e-7 * n);
    RC_ASSERT(found >= 0.0 && found <= 1.0);
  });
}

TEST_CASE("an average has the same bits in any order and by any merge") {
  holds("shuffled", [] {
    const std::vector<layer> layers = draw_layers();
    std::vector<layer> shuffled = layers;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    weighted_average whole = weighted_average::empty();
    for (const layer& each : layers) {
      whole.add(each.alpha, each.colour);
    }
    std::array<weighted_average, 2> part{weighted_average::empty(), weighted_average::empty()};
    for (const layer& each : shuffled) {
      part[*rc::gen::inRange<std::size_t>(0u, 2u)].add(each.alpha, each.colour);
    }
    part[0].merge(part[1]);
    RC_ASSERT(bits(part[0]) == bits(whole));
  });
}

TEST_CASE("a weight of depth falls from alpha to its least, by the paper's formula") {
  holds("any depths", [] {
    const float alpha = draw_share();
    const float z = draw_share();
    const double expected = alpha * std::max(1e-2, 3e3 * std::pow(1.0 - z, 3.0)) / 3e3;
    RC_ASSERT(std::abs(depth_weight(alpha, z) - expected) <= 1e-6 * expected + 1e-12);
  });
  CHECK(depth_weight(1.0f, 0.0f) == 1.0f);
  CHECK(depth_weight(0.25f, -1.0f) == 0.25f);
  CHECK(depth_weight(0.25f, nan) == 0.25f);
}

}  // namespace pelage::test
