// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/tail.hpp>

#include "composite/layers.hpp"
#include "property.hpp"
#include "sweep.hpp"

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

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

static_assert(sizeof(tail) == 20);

std::array<std::uint32_t, 5> bits(const tail& t) {
  return std::bit_cast<std::array<std::uint32_t, 5>>(t);
}

tail tail_of(const std::vector<layer>& layers) {
  tail t = empty_tail();
  for (const layer& each : layers) {
    t = add_fragment(t, each.alpha, each.colour);
  }
  return t;
}

/// Layers that at times fill a tail's sums to the brim.
std::vector<layer> draw_bright_layers() {
  std::vector<layer> layers = draw_layers();
  const float brightness = *rc::gen::element(1.0f, 300.0f, 5000.0f, 1e30f);
  for (layer& each : layers) {
    each.colour *= brightness;
  }
  const std::vector<layer> once = layers;
  for (int more = *rc::gen::element(0, 7); more > 0; --more) {
    layers.insert(layers.end(), once.begin(), once.end());
  }
  return layers;
}

/// The layers' tails merged two by two, at random, until one is left.
tail merged_at_random(const std::vector<layer>& layers) {
  std::vector<tail> parts{empty_tail()};
  for (const layer& each : layers) {
    parts.push_back(add_fragment(empty_tail(), each.alpha, each.colour));
  }
  while (parts.size() > 1u) {
    const tail last = parts.back();
    parts.pop_back();
    tail& other = parts[*rc::gen::inRange<std::size_t>(0u, parts.size())];
    other = *rc::gen::arbitrary<bool>() ? merge(other, last) : merge(last, other);
  }
  return parts.front();
}

TEST_CASE("any order of arrival gives the same bits, saturated or not") {
  holds("shuffled", [] {
    const std::vector<layer> layers = draw_bright_layers();
    std::vector<layer> shuffled = layers;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    RC_ASSERT(bits(tail_of(shuffled)) == bits(tail_of(layers)));
  });
}

TEST_CASE("any tree of merges gives the same bits, saturated or not") {
  holds("merged two by two", [] {
    const std::vector<layer> layers = draw_bright_layers();
    RC_ASSERT(bits(merged_at_random(layers)) == bits(tail_of(layers)));
  });
}

/// A sum in units of 2⁻²⁰, each term rounded to the nearest, clamped to the end of the range once at the end.
struct wide_sum {
  std::uint64_t units = 0u;

  void add(float x) { units += static_cast<std::uint64_t>(std::floor(1048576.0 * x + 0.5)); }
  std::uint32_t held() const { return static_cast<std::uint32_t>(std::min<std::uint64_t>(units, 0xffffffffu)); }
};

TEST_CASE("every sum is that of 64-bit integers, clamped to the end of the range by itself") {
  holds("sums of alpha and of alpha times colour", [] {
    const std::vector<layer> layers = draw_bright_layers();
    wide_sum weight, red, green, blue;
    for (const layer& each : layers) {
      const glm::vec3 share = each.alpha * clamp_keeping_hue(each.colour);
      weight.add(each.alpha);
      red.add(share.x);
      green.add(share.y);
      blue.add(share.z);
    }
    const tail t = tail_of(layers);
    RC_ASSERT(t.weight == weight.held());
    RC_ASSERT(t.red == red.held() && t.green == green.held() && t.blue == blue.held());
  });
}

TEST_CASE("4096 opaque white fragments fill the range, one fewer does not") {
  const std::vector<layer> layers(4095u, layer{1.0f, glm::vec3(1.0f, 0.5f, 1.0f)});
  tail t = tail_of(layers);
  CHECK(bits(t) == std::array<std::uint32_t, 5>{0xffffffffu, 4095u << 20u, 4095u << 20u, 4095u << 19u, 4095u << 20u});
  t = add_fragment(t, 1.0f, glm::vec3(1.0f, 0.5f, 1.0f));
  CHECK(bits(t) == std::array<std::uint32_t, 5>{0xffffffffu, 0xffffffffu, 0xffffffffu, 1u << 31u, 0xffffffffu});
}

/// A colour in double, scaled until no channel is above 64.
glm::dvec3 clamped(const glm::vec3& colour) {
  const double most = std::max({double{colour.x}, double{colour.y}, double{colour.z}});
  return glm::dvec3(colour) * std::min(1.0, 64.0 / most);
}

/// Of one hue and any brightness, often far beyond what a tail holds.
std::vector<layer> draw_layers_of(const glm::vec3& hue) {
  std::vector<layer> layers = draw_layers();
  for (layer& each : layers) {
    each.colour = hue * std::pow(10.0f, static_cast<float>(*rc::gen::inRange(-1, 38)));
  }
  return layers;
}

TEST_CASE("a colour up to 64 whites is itself, a brighter one is scaled as a whole") {
  holds("by a scale in double", [] {
    const float brightness = *rc::gen::element(1.0f, 64.0f, 65.0f, 1e4f, 1e38f, 3.4e38f);
    const glm::vec3 colour = brightness * draw_colour();
    const glm::vec3 kept = clamp_keeping_hue(colour);
    const glm::dvec3 expected = clamped(colour);
    for (int c = 0; c < 3; ++c) {
      RC_ASSERT(std::abs(kept[c] - expected[c]) <= 1e-5 * expected[c] + 1e-37);
    }
    RC_ASSERT(brightness > 64.0f || kept == colour);
  });
}

TEST_CASE("no brightness changes a hue, in any order, while the alphas' sum is below 63") {
  holds("mean in double, and proportions", [] {
    const glm::vec3 hue(1.0f, draw_share(), draw_share());
    const std::vector<layer> layers = draw_layers_of(hue);
    glm::dvec3 sum(0.0);
    double weight = 0.0;
    for (const layer& each : layers) {
      sum += static_cast<double>(each.alpha) * clamped(each.colour);
      weight += each.alpha;
    }
    RC_PRE(weight > 1e-3);
    const glm::dvec3 mean(mean_colour(tail_of(layers)));
    const double rounding = 33.0 * 0x1p-20 * static_cast<double>(layers.size()) / weight;
    for (int c = 0; c < 3; ++c) {
      RC_ASSERT(std::abs(mean[c] - sum[c] / weight) <= rounding + 2e-5 * mean[c]);
      RC_ASSERT(std::abs(mean[c] - mean.x * hue[c]) <=
                0x1p-20 * static_cast<double>(layers.size()) / weight + 1e-5 + 1e-6 * mean.x);
    }
    std::vector<layer> turned(layers.rbegin(), layers.rend());
    RC_ASSERT(bits(tail_of(turned)) == bits(tail_of(layers)));
  });
}

TEST_CASE("light in physical units keeps its hue over the scene's white, and without one") {
  const glm::vec3 radiance(10000.0f, 5000.0f, 1250.0f);
  const glm::dvec3 hue(1.0, 0.5, 0.125);
  const auto far_from_hue = [&](const glm::vec3& seen) { return glm::length(glm::dvec3(seen) / double{seen.x} - hue); };
  const glm::vec3 by_white = 10000.0f * mean_colour(tail_of(std::vector<layer>(16u, {0.3f, radiance / 10000.0f})));
  CHECK(far_from_hue(by_white) < 1e-5);
  CHECK(std::abs(by_white.x - 10000.0f) < 0.1f);
  const glm::vec3 at_limit = mean_colour(tail_of(std::vector<layer>(16u, {0.3f, radiance})));
  CHECK(far_from_hue(at_limit) < 1e-5);
  CHECK(std::abs(at_limit.x - 64.0f) < 1e-3f);
}

TEST_CASE("the transmittance is the product of 1 - alpha") {
  holds("within 3.4e-7 a fragment, and 1e-7 of its octaves", [] {
    const std::vector<layer> layers = draw_layers(0.9f);
    double product = 1.0;
    double tolerance = 1e-7;
    for (const layer& each : layers) {
      product *= 1.0 - each.alpha;
      tolerance += 3.4e-7 + 1e-7 * (1.0 - std::log2(1.0 - each.alpha));
    }
    RC_ASSERT(relative_error(transmittance_of(tail_of(layers)), product) < tolerance);
  });
}

TEST_CASE("an empty tail passes all, shows black, and changes nothing it is merged with") {
  CHECK(transmittance_of(empty_tail()) == 1.0f);
  CHECK(mean_colour(empty_tail()) == glm::vec3(0.0f));
  holds("identity", [] {
    const tail t = tail_of(draw_bright_layers());
    RC_ASSERT(bits(merge(t, empty_tail())) == bits(t) && bits(merge(empty_tail(), t)) == bits(t));
  });
}

TEST_CASE("the mean colour is weighted by alpha") {
  holds("mean in double, within half a unit for each term of both sums", [] {
    const std::vector<layer> layers = draw_layers();
    glm::dvec3 sum(0.0);
    double weight = 0.0;
    for (const layer& each : layers) {
      sum += static_cast<double>(each.alpha) * glm::dvec3(each.colour);
      weight += each.alpha;
    }
    RC_PRE(weight > 1e-3);
    const glm::dvec3 error = glm::dvec3(mean_colour(tail_of(layers))) - sum / weight;
    const double rounding = 0x1p-20 * static_cast<double>(layers.size()) / weight + 2e-7;
    RC_ASSERT(std::abs(error.x) <= rounding && std::abs(error.y) <= rounding && std::abs(error.z) <= rounding);
  });
}

TEST_CASE("alphas below 2^-21 are too small for the sums") {
  const tail t = add_fragment(empty_tail(), 0.99f * 0x1p-21f, glm::vec3(1.0f));
  CHECK(mean_colour(t) == glm::vec3(0.0f));
  CHECK(mean_colour(add_fragment(empty_tail(), 0x1p-21f, glm::vec3(1.0f))) == glm::vec3(1.0f));
}

TEST_CASE("alpha is clamped to [0, 1], NaN counts as 0") {
  const glm::vec3 colour(0.5f, 0.25f, 1.0f);
  for (const float none : {-1.0f, -inf, nan}) {
    CHECK(bits(add_fragment(empty_tail(), none, colour)) == bits(empty_tail()));
  }
  for (const float all : {2.0f, inf}) {
    CHECK(bits(add_fragment(empty_tail(), all, colour)) == bits(add_fragment(empty_tail(), 1.0f, colour)));
  }
}

TEST_CASE("NaN and negative colours count as 0, infinite ones as the brightest") {
  const tail t = add_fragment(empty_tail(), 0.5f, glm::vec3(nan, -1.0f, inf));
  CHECK((t.red == 0u && t.green == 0u));
  CHECK(std::abs(t.blue - 32.0 * 0x1p20) < 1e-5 * 32.0 * 0x1p20);
  CHECK(add_fragment(empty_tail(), 0.5f, glm::vec3(64.0f)).red == 32u << 20u);
  CHECK(add_fragment(empty_tail(), 0.0f, glm::vec3(inf)).red == 0u);
}

}  // namespace pelage::test
