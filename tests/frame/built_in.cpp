// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/built_in.hpp"

#include "property.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pelage::frame;
using pelage::test::holds;

namespace {

bool is_finite(glm::vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

TEST_CASE("built-in strands have the counts asked for, are finite, stay outside the bust and near it") {
  holds("strands are sound", [](std::uint64_t seed) {
    const auto strands = *rc::gen::inRange<std::uint32_t>(0, 200);
    const auto segments = *rc::gen::inRange<std::uint32_t>(1, 80);
    const hair_model model = make_built_in(strands, segments, seed);
    RC_ASSERT(model.strand_count() == strands);
    RC_ASSERT(model.segment_count() == std::size_t{strands} * segments);
    RC_ASSERT(model.points.size() == std::size_t{strands} * (segments + 1));
    RC_ASSERT(model.thickness.size() == model.points.size());
    RC_ASSERT(model.colour.size() == model.points.size());
    for (std::size_t i = 0; i < model.points.size(); ++i) {
      RC_ASSERT(is_finite(model.points[i]));
      RC_ASSERT(!inside_bust(model.points[i]));
      RC_ASSERT(glm::length(model.points[i]) < 3.0F);
      RC_ASSERT(model.thickness[i] > 0.0F);
      RC_ASSERT(std::min({model.colour[i].r, model.colour[i].g, model.colour[i].b}) > 0.0F);
    }
  });
}

TEST_CASE("segments of a strand are neither degenerate nor longer than a small part of it") {
  constexpr std::uint32_t segments = 48;
  const hair_model model = make_built_in(5000, segments, 3);
  float longest = 0.0F;
  float shortest = 1e9F;
  float least_total = 1e9F;
  float most_total = 0.0F;
  for (std::size_t s = 0; s < model.strand_count(); ++s) {
    float total = 0.0F;
    for (std::uint32_t i = model.first_point[s]; i + 1 < model.first_point[s + 1]; ++i) {
      const float length = glm::length(model.points[i + 1] - model.points[i]);
      longest = std::max(longest, length);
      shortest = std::min(shortest, length);
      total += length;
    }
    least_total = std::min(least_total, total);
    most_total = std::max(most_total, total);
  }
  CHECK(shortest > 1e-4F);
  CHECK(longest < 0.35F);
  CHECK(least_total > 0.2F);
  CHECK(most_total < 6.0F);
}

TEST_CASE("the hair starts on the scalp, parts, falls to the shoulders and leaves the face free") {
  const hair_model model = make_built_in(4000, 32, 1);
  std::size_t at_shoulders = 0;
  std::size_t before_face = 0;
  for (std::size_t s = 0; s < model.strand_count(); ++s) {
    const glm::vec3 root = model.points[model.first_point[s]];
    const glm::vec3 tip = model.points[model.first_point[s + 1] - 1];
    CHECK(bust[0].level(root) < 1.06F);
    CHECK_FALSE((root.z > 0.5F && root.y < 0.4F));
    if (tip.y < -1.2F && tip.y > -2.0F) ++at_shoulders;
    for (std::uint32_t i = model.first_point[s]; i < model.first_point[s + 1]; ++i) {
      const glm::vec3 p = model.points[i];
      if (p.z > 0.6F && std::abs(p.x) < 0.2F && std::abs(p.y + 0.2F) < 0.3F) ++before_face;
    }
  }
  CHECK(at_shoulders > model.strand_count() * 7 / 10);
  CHECK(before_face < model.points.size() / 5000);
}

TEST_CASE("the built-in hair has the same bits in every run and on one thread") {
  const hair_model a = make_built_in(700, 20, 5);
  const hair_model b = make_built_in(700, 20, 5);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const hair_model c = make_built_in(700, 20, 5);
  CHECK((a.points == b.points && a.colour == b.colour && a.thickness == b.thickness));
  CHECK((a.points == c.points && a.colour == c.colour && a.thickness == c.thickness));
  CHECK(make_built_in(700, 20, 6).points != a.points);
}

TEST_CASE("fewer strands are the first of more strands") {
  const hair_model few = make_built_in(50, 20, 5);
  const hair_model many = make_built_in(500, 20, 5);
  CHECK(std::equal(few.points.begin(), few.points.end(), many.points.begin()));
}

TEST_CASE("no strands are an empty model, no segments and too many points are refused") {
  CHECK(make_built_in(0, 48, 1).strand_count() == 0);
  CHECK_THROWS_AS(static_cast<void>(make_built_in(10, 0, 1)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(make_built_in(0, 0, 1)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(make_built_in(0xffffffff, 1, 1)), std::length_error);
  CHECK_THROWS_AS(static_cast<void>(make_built_in(2, 0xffffffff, 1)), std::length_error);
}

bool is_hit(const surface_hit<float>& hit) {
  return hit.distance < std::numeric_limits<float>::infinity();
}

TEST_CASE("a ray that hits the bust enters it there") {
  holds("hits are entries", [] {
    const auto part = [] { return static_cast<float>(*rc::gen::inRange(-1000, 1001)) * 0.001F; };
    const float x = part();
    const float y = part();
    const glm::vec3 origin(3.0F * x, 3.0F * y, 4.0F);
    const float dx = part();
    const glm::vec3 direction(0.3F * dx, 0.2F * y, -1.0F);
    const surface_hit<float> hit = hit_bust(origin, direction);
    if (is_hit(hit)) {
      RC_ASSERT(!inside_bust(origin + direction * (hit.distance - 1e-3F)));
      float least = 1e9F;
      for (const ellipsoid& e : bust)
        least = std::min(least, e.level(origin + direction * hit.distance));
      RC_ASSERT(std::abs(least - 1.0F) < 1e-3F);
      RC_ASSERT(std::abs(glm::length(hit.normal) - 1.0F) < 1e-5F);
    } else {
      for (int i = 0; i < 200; ++i) {
        RC_ASSERT(!inside_bust(origin + direction * (static_cast<float>(i) * 0.05F)));
      }
    }
  });
  CHECK(is_hit(hit_bust({0, 0, 5}, {0, 0, -1})));
  CHECK_FALSE(is_hit(hit_bust({0, 0, 5}, {0, 0, 1})));
}
