// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/blends/deep_opacity.hpp"

#include "frame/blends/blend_choice.hpp"
#include "frame/draws.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelage::test {

using namespace frame;

using fragments = std::vector<layer>;

glm::vec3 blend(const fragments& all, const glm::vec3& background, bool is_corrected, std::uint32_t layers) {
  return layers == 4 ? blend_deep_opacity<4>(all, background, is_corrected)
                     : blend_deep_opacity<32>(all, background, is_corrected);
}

/// Depths in steps of a half from 8 to 8 + `layers` at most, the ends of which are taken: a place in a layer is exact.
fragments any_fragments(std::uint32_t layers, float most_alpha) {
  fragments all;
  const auto steps = 2 * static_cast<int>(layers);
  const auto count = static_cast<std::uint32_t>(*rc::gen::inRange(2, 24));
  for (std::uint32_t id = 0; id < count; ++id) {
    const int step = id == 0 ? 0 : id == 1 ? steps : *rc::gen::inRange(0, steps + 1);
    const float depth = 8.0F + 0.5F * static_cast<float>(step);
    all.push_back({{depth, id}, any_float(0.0F, most_alpha), any_vec3(0.0F, 2.0F)});
  }
  return all;
}

double octaves(const layer& f) {
  return -std::log2(1.0 - static_cast<double>(f.alpha));
}

/// What truly passes all, and what is seen where a fragment is dimmed by the layers before its own and by the share of
/// its own layer that lies before it.
glm::dvec3 by_definition(const fragments& all, const glm::vec3& background, bool is_corrected, std::uint32_t layers) {
  const auto position = [](const layer& f) { return static_cast<double>(f.where.depth) - 8.0; };
  const auto layer_of = [&](const layer& f) { return std::min(std::floor(position(f)), layers - 1.0); };
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  double passed = 1.0;
  for (const layer& f : all) {
    double before = 0.0;
    for (const layer& other : all) {
      const bool is_own = other.where.id == f.where.id;
      const double share = layer_of(other) < layer_of(f)    ? 1.0
                           : layer_of(other) == layer_of(f) ? position(f) - layer_of(f)
                                                            : 0.0;
      before += is_own && is_corrected ? 0.0 : share * octaves(other);
    }
    const double weight = static_cast<double>(f.alpha) * std::exp2(-before);
    sum += weight * glm::dvec3(f.radiance);
    weights += weight;
    passed *= 1.0 - static_cast<double>(f.alpha);
  }
  if (is_corrected && weights > 0.0) sum *= (1.0 - passed) / weights;
  return sum + passed * glm::dvec3(background);
}

/// Fragment over fragment, nearest first.
glm::dvec3 over_all(fragments all, const glm::vec3& background) {
  std::sort(all.begin(), all.end(), [](const layer& a, const layer& b) { return before(a.where, b.where); });
  glm::dvec3 sum(0.0);
  double passed = 1.0;
  for (const layer& f : all) {
    sum += passed * static_cast<double>(f.alpha) * glm::dvec3(f.radiance);
    passed *= 1.0 - static_cast<double>(f.alpha);
  }
  return sum + passed * glm::dvec3(background);
}

bool near(const glm::vec3& a, const glm::dvec3& b, double error) {
  return glm::length(glm::dvec3(a) - b) < error;
}

TEST_CASE("deep opacity blending is what its layers hold, summed up by hand, as the papers have it and corrected") {
  holds("any fragments", [] {
    const std::uint32_t layers = *rc::gen::element(4U, 32U);
    const bool is_corrected = *rc::gen::arbitrary<bool>();
    fragments all = any_fragments(layers, 0.9F);
    all.front().alpha = std::max(all.front().alpha, 0.05F);  // its weight, so that the sum of all is no rounding
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    RC_ASSERT(
        near(blend(all, background, is_corrected, layers), by_definition(all, background, is_corrected, layers), 2e-3));
  });
}

TEST_CASE("corrected, it is sorting where no layer holds two, whatever the alphas") {
  holds("up to 32 fragments", [] {
    std::vector<int> layers(30);
    for (std::size_t i = 0; i < layers.size(); ++i)
      layers[i] = static_cast<int>(i) + 1;
    std::shuffle(layers.begin(), layers.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    layers.resize(*rc::gen::inRange<std::size_t>(0, 31));
    fragments all{{{8.0F, 100U}, any_float(0.05F, 1.0F), any_vec3(0.0F, 2.0F)},
                  {{40.0F, 101U}, any_float(0.0F, 1.0F), any_vec3(0.0F, 2.0F)}};
    for (const int at : layers) {
      const float inside = any_float(0.05F, 0.95F);
      all.push_back({{8.0F + static_cast<float>(at) + inside, static_cast<std::uint32_t>(at)},
                     any_float(0.0F, 0.9F),
                     any_vec3(0.0F, 2.0F)});
    }
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    RC_ASSERT(near(blend(all, background, true, 32), over_all(all, background), 1e-3));
  });
}

TEST_CASE("no order of fragments changes a bit, and finite colours stay finite") {
  holds("any fragments, opaque ones too", [] {
    fragments all = any_fragments(32, 1.0F);
    if (*rc::gen::arbitrary<bool>()) all.back().alpha = 1.0F;
    fragments other = all;
    std::shuffle(other.begin(), other.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    for (const bool is_corrected : {false, true}) {
      const glm::vec3 seen = blend(all, background, is_corrected, 32);
      const glm::vec3 again = blend(other, background, is_corrected, 32);
      RC_ASSERT(std::memcmp(&seen, &again, sizeof(seen)) == 0);
      RC_ASSERT((std::isfinite(seen.x) && std::isfinite(seen.y) && std::isfinite(seen.z)));
    }
  });
}

TEST_CASE("without fragments the background is left, and one is over it") {
  for (const bool is_corrected : {false, true}) {
    const glm::vec3 background(0.5F, 0.25F, 1.0F);
    CHECK(blend({}, background, is_corrected, 32) == background);
    const fragments one{{{3.0F, 7U}, 0.75F, glm::vec3(1.0F, 0.5F, 0.0F)}};
    CHECK(near(blend(one, background, is_corrected, 32), over_all(one, background), 1e-5));
  }
}

TEST_CASE("as the papers have it the farthest fragment lies before itself") {
  // Two fragments that let half of the light pass, black before white: a quarter of white is seen, an eighth with
  // itself before it. Corrected, the sum of weights is right already.
  const fragments two{{{1.0F, 0U}, 0.5F, glm::vec3(0.0F)}, {{2.0F, 1U}, 0.5F, glm::vec3(1.0F)}};
  CHECK(blend(two, glm::vec3(0.0F), false, 32).x == doctest::Approx(0.125).epsilon(1e-5));
  CHECK(blend(two, glm::vec3(0.0F), true, 32).x == doctest::Approx(0.25).epsilon(1e-5));
}

TEST_CASE("layers are one of the compiled numbers") {
  for (const std::string method : {"deep_opacity", "deep_opacity_corrected"}) {
    for (const std::uint32_t layers : blended_layers)
      CHECK(parse_blend(method + ":" + std::to_string(layers)).size == layers);
    for (const char* argument : {"", ":", ":0", ":5", ":-4", ":32.0"})
      CHECK_THROWS_AS((void)parse_blend(method + argument), std::invalid_argument);
  }
  CHECK(parse_blend("deep_opacity:32").method == blend_method::deep_opacity);
  CHECK(parse_blend("deep_opacity_corrected:32").method == blend_method::deep_opacity_corrected);
}

}  // namespace pelage::test
