// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/visibility/deep_shadow_map.hpp>

#include "property.hpp"

#include <algorithm>
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

static_assert(sizeof(deep_shadow_vertex) == 8);

struct occluder {
  float depth;
  float alpha;
};

struct deep_map {
  std::vector<deep_shadow_vertex> vertices;
  std::uint32_t count;

  [[nodiscard]] float at(float depth) const {
    std::vector<deep_shadow_vertex> memory = vertices;
    return deep_shadow_at(span_vertex_storage{memory}, 3u, count, depth);
  }
};

/// The map of a sorted list, from vertex 3 on, in a storage with no room beyond what is promised to be enough.
deep_map map_of(const std::vector<occluder>& sorted, float max_error) {
  deep_map map{std::vector<deep_shadow_vertex>(3u + 2u * sorted.size()), 0u};
  span_vertex_storage storage{map.vertices};
  deep_shadow_builder builder = deep_shadow_builder::begin(3u, max_error);
  for (const occluder& each : sorted) {
    builder.add(storage, each.depth, each.alpha);
  }
  builder.finish(storage);
  map.count = builder.count;
  return map;
}

/// The product over all strictly before a depth, as the header defines depths and alphas.
double truth_at(const std::vector<occluder>& sorted, float depth) {
  double passed = 1.0;
  for (const occluder& each : sorted) {
    if (detail::clamped_depth(each.depth) < detail::clamped_depth(depth)) passed *= 1.0 - double{saturate(each.alpha)};
  }
  return passed;
}

float draw_depth() {
  return *rc::gen::oneOf(
      rc::gen::map(rc::gen::inRange(0, 32), [](int i) { return 0.25f * static_cast<float>(i); }),
      rc::gen::map(rc::gen::inRange(0, 8), [](int i) { return std::bit_cast<float>(0x3f800000 + i); }),
      rc::gen::map(rc::gen::inRange(0, 1 << 20), [](int i) { return 1.0f + static_cast<float>(i) / 1048576.0f; }),
      rc::gen::element(0.0f, -1.0f, 1e-30f, 1e-45f, -1e-45f, 1e30f, 3e38f, -3e38f, inf, -inf));
}

float draw_alpha() {
  return *rc::gen::oneOf(
      rc::gen::map(rc::gen::inRange(0, 1001), [](int i) { return static_cast<float>(i) / 1000.0f; }),
      rc::gen::map(rc::gen::inRange(0, 1001), [](int i) { return static_cast<float>(i) / 20000.0f; }),
      rc::gen::element(0.0f, 1.0f, 1e-7f, 2.0f, -1.0f, nan));
}

std::vector<occluder> draw_occluders() {
  std::vector<occluder> all(*rc::gen::inRange<std::size_t>(0u, 60u));
  for (occluder& each : all) {
    each = occluder{draw_depth(), draw_alpha()};
  }
  std::sort(all.begin(), all.end(), [](const occluder& a, const occluder& b) { return a.depth < b.depth; });
  return all;
}

/// Depths at which a wrong map shows: at, round and between all occluders.
std::vector<float> telling_depths(const std::vector<occluder>& sorted) {
  std::vector<float> depths{-inf, -1.0f, 0.0f, 5.0f, inf};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const float z = sorted[i].depth;
    depths.insert(depths.end(), {z, std::nextafter(z, inf), std::nextafter(z, -inf)});
    if (i > 0) depths.push_back(0.5f * detail::clamped_depth(z) + 0.5f * detail::clamped_depth(sorted[i - 1].depth));
  }
  std::sort(depths.begin(), depths.end());
  return depths;
}

TEST_CASE("no error of a compressed map is above the given one, anywhere") {
  holds("any list", [] {
    const std::vector<occluder> sorted = draw_occluders();
    const float max_error = *rc::gen::element(1e-5f, 1e-4f, 1e-3f, 0.01f, 0.03f, 0.1f, 0.3f, 0.5f, 1.0f);
    const deep_map map = map_of(sorted, max_error);
    for (const float depth : telling_depths(sorted)) {
      RC_ASSERT(std::abs(double{map.at(depth)} - truth_at(sorted, depth)) <= max_error);
    }
  });
}

/// Up to 2²⁰ fragments whose product is told by a double, at depths of which some are the same. What a float loses at
/// each adds up where their alphas are alike.
std::vector<occluder> draw_long_list() {
  std::vector<occluder> all(static_cast<std::size_t>(std::exp2(0.01 * *rc::gen::inRange(0, 2001))));
  const double octaves = std::exp2(0.01 * *rc::gen::inRange(-1000, 700));
  const auto mean = static_cast<float>(std::min(1.0, octaves / static_cast<double>(all.size())));
  const bool alike = *rc::gen::arbitrary<bool>();
  std::minstd_rand random(*rc::gen::arbitrary<std::uint32_t>());
  std::uniform_real_distribution<float> share;
  float depth = 0.0f;
  for (occluder& each : all) {
    depth += static_cast<float>(random() % 3u);
    each = occluder{depth, alike ? mean : 2.0f * mean * share(random)};
  }
  return all;
}

TEST_CASE("no number of fragments up to 2^20 takes a map farther from the product than its error and 2e-7") {
  holds("long lists", [] {
    const std::vector<occluder> sorted = draw_long_list();
    const float max_error = *rc::gen::element(0.0f, 1e-7f, 1e-6f, 2e-6f, 1e-5f, 1e-3f, 0.1f);
    const double allowed = std::max(double{max_error}, 2e-7);
    std::vector<deep_shadow_vertex> vertices(2u * sorted.size());
    span_vertex_storage storage{vertices};
    deep_shadow_builder builder = deep_shadow_builder::begin(0u, max_error);
    for (const occluder& each : sorted) {
      builder.add(storage, each.depth, each.alpha);
    }
    builder.finish(storage);
    double truth = 1.0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i == 0 || sorted[i].depth > sorted[i - 1].depth) {
        RC_ASSERT(std::abs(double{deep_shadow_at(storage, 0u, builder.count, sorted[i].depth)} - truth) <= allowed);
      }
      truth *= 1.0 - double{saturate(sorted[i].alpha)};
    }
    RC_ASSERT(std::abs(double{deep_shadow_at(storage, 0u, builder.count, inf)} - truth) <= allowed);
  });
}

/// What a product loses at most: by 2⁻²⁴ of itself twice an octave, and in the end once more.
double rounding_of(double product) {
  return product > 0.0 ? 0x1p-23 * product * (1.0 - std::log2(product)) + 0x1p-149 : 0.0;
}

TEST_CASE("with an error of 0 the map is the truth, small or large, except for rounding") {
  holds("any list", [] {
    const std::vector<occluder> sorted = draw_occluders();
    const deep_map map = map_of(sorted, *rc::gen::element(0.0f, 1e-7f, 1e-6f, -1.0f, nan));
    for (const float depth : telling_depths(sorted)) {
      const double truth = truth_at(sorted, depth);
      RC_ASSERT(std::abs(double{map.at(depth)} - truth) <= rounding_of(truth));
    }
  });
}

TEST_CASE("with an error of 0 no step is too small for its distance") {
  const std::vector<occluder> dark{{1.0f, 0.99999f}, {1.0f, 0.99999f}, {1.0f, 0.99999f}, {1e30f, 0.5f}};
  const double truth = truth_at(dark, 1e30f);
  CHECK(std::abs(map_of(dark, 0.0f).at(1e30f) - truth) <= rounding_of(truth));
  CHECK(std::abs(map_of(dark, 0.0f).at(1.2e30f) - 0.5 * truth) <= rounding_of(0.5 * truth));
}

TEST_CASE("transmittance never rises, begins at 1 and stays in [0, 1]") {
  holds("any list, any error", [] {
    const std::vector<occluder> sorted = draw_occluders();
    const deep_map map = map_of(sorted, *rc::gen::element(0.0f, 1e-4f, 0.01f, 0.1f, 1.0f));
    float last = 1.0f;
    RC_ASSERT(map.at(-inf) == 1.0f);
    for (const float depth : telling_depths(sorted)) {
      RC_ASSERT(map.at(depth) <= last);
      RC_ASSERT(map.at(depth) >= 0.0f);
      last = map.at(depth);
    }
  });
}

TEST_CASE("a greater error needs no more vertices on hair, and far fewer") {
  std::vector<occluder> hair;
  for (int i = 0; i < 200; ++i) {
    hair.push_back(
        occluder{1.0f + 0.01f * static_cast<float>(i) + 0.004f * std::sin(7.0f * static_cast<float>(i)), 0.03f});
  }
  std::vector<std::uint32_t> counts;
  for (const float error : {0.0f, 0.003f, 0.01f, 0.03f, 0.1f}) {
    counts.push_back(map_of(hair, error).count);
  }
  CHECK(counts[0] == 400u);
  CHECK(std::is_sorted(counts.rbegin(), counts.rend()));
  CHECK(counts[3] <= 20u);
}

TEST_CASE("two plateaus and a step: the vertices are where one would put them") {
  const deep_map map = map_of({{1.0f, 0.5f}, {2.0f, 0.5f}}, 0.0f);
  REQUIRE(map.count == 4u);
  const float expected[4][2] = {{1.0f, 1.0f}, {1.0f, 0.5f}, {2.0f, 0.5f}, {2.0f, 0.25f}};
  for (std::size_t i = 0; i < 4u; ++i) {
    CHECK(map.vertices[3u + i].depth == expected[i][0]);
    CHECK(map.vertices[3u + i].transmittance == expected[i][1]);
  }
}

TEST_CASE("fragments at NaN depths are left out, a list without others passes all light") {
  CHECK(map_of({}, 0.1f).at(1.0f) == 1.0f);
  CHECK(map_of({{nan, 1.0f}}, 0.1f).count == 0u);
  CHECK(map_of({{nan, 1.0f}, {1.0f, 0.5f}, {nan, 1.0f}}, 0.0f).at(2.0f) == 0.5f);
}

}  // namespace pelage::test
