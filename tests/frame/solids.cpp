// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/solids.hpp"

#include "frame/base/random.hpp"
#include "frame/fibres.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelage::test {

using namespace frame;

solids any_solids() {
  solids s;
  for (int n = *rc::gen::inRange(0, 5); n > 0; --n) {
    const glm::vec3 centre = any_vec3(-2.0F, 2.0F);
    s.parts.push_back({centre, any_vec3(0.3F, 1.5F)});
  }
  if (*rc::gen::arbitrary<bool>()) s.floor = any_float(-3.0F, 0.0F);
  return s;
}

bool is_hit(const solid_hit<float>& hit) {
  return hit.distance < std::numeric_limits<float>::infinity();
}

/// The solids that hold a point, by number; the floor holds all that lies below it.
std::vector<bool> holders(const solids& s, const glm::vec3& p, float margin) {
  std::vector<bool> inside;
  for (const ellipsoid& part : s.parts)
    inside.push_back(part.level(p) < 1.0F - margin);
  inside.push_back(s.floor && p.y < *s.floor - margin);
  return inside;
}

TEST_CASE("a ray hits where it first enters a solid that it did not start in") {
  holds("against samples along the ray", [] {
    const solids s = any_solids();
    const glm::vec3 origin = any_vec3(-5.0F, 5.0F);
    const glm::vec3 direction = glm::normalize(any_vec3(-2.0F, 2.0F) - origin) * any_float(0.5F, 2.0F);
    const solid_hit<float> hit = s.hit(origin, direction);

    const std::vector<bool> at_start = holders(s, origin, 0.0F);
    for (float t = 0.01F; t < std::min(hit.distance, 40.0F); t += 0.01F) {
      const std::vector<bool> now = holders(s, origin + t * direction, 0.02F);
      for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i]) RC_ASSERT(at_start[i]);
      }
    }
    if (!is_hit(hit)) return;
    RC_ASSERT(hit.distance > 0.0F);
    RC_ASSERT(std::abs(glm::length(hit.normal) - 1.0F) < 1e-5F);
    const glm::vec3 p = origin + hit.distance * direction;
    float off = s.floor ? std::abs(p.y - *s.floor) : 1e30F;
    for (const ellipsoid& part : s.parts)
      off = std::min(off, std::abs(part.level(p) - 1.0F));
    RC_ASSERT(off < 1e-3F);
  });
}

TEST_CASE("many rays at once hit what each hits alone, bit for bit") {
  holds("in every lane", [] {
    const solids s = any_solids();
    wide3_builder origins;
    wide3_builder directions;
    std::vector<solid_hit<float>> alone;
    for (int k = 0; k < wide_width; ++k) {
      const glm::vec3 origin = any_vec3(-5.0F, 5.0F);
      const glm::vec3 direction = any_vec3(-2.0F, 2.0F) - origin;
      origins.set(k, origin);
      directions.set(k, direction);
      alone.push_back(s.hit(origin, direction));
    }
    const solid_hit<wide> together = s.hit(origins.done(), directions.done());
    for (int k = 0; k < wide_width; ++k) {
      const solid_hit<float>& one = alone[static_cast<std::size_t>(k)];
      RC_ASSERT(together.distance.lane[k] == one.distance);
      if (!is_hit(one)) continue;
      RC_ASSERT(lane_of(together.normal, k) == one.normal);
      RC_ASSERT(lane_of(together.colour, k) == one.colour);
      RC_ASSERT(together.haze.lane[k] == one.haze);
    }
  });
}

TEST_CASE("a sphere anywhere and of any size has its own normals") {
  holds("radial", [] {
    const float radius = std::pow(10.0F, any_float(-3.0F, 3.0F));
    const glm::vec3 centre = radius * any_vec3(-10.0F, 10.0F);
    solids s;
    s.parts.push_back({centre, glm::vec3(radius)});
    const glm::vec3 target = centre + radius * any_vec3(-0.5F, 0.5F);
    const glm::vec3 origin = centre + radius * (any_vec3(-1.0F, 1.0F) + glm::vec3(0.0F, 0.0F, 4.0F));
    const solid_hit<float> hit = s.hit(origin, target - origin);
    RC_ASSERT(is_hit(hit));
    const glm::vec3 outward = (origin + hit.distance * (target - origin) - centre) / radius;
    RC_ASSERT(glm::length(hit.normal - outward) < 1e-3F);
    RC_ASSERT(hit.colour == s.skin);
  });
}

TEST_CASE("the floor is hit from above alone, and never at infinity") {
  solids s;
  s.floor = -1.0F;
  const auto along = [](const solids& all, const glm::vec3& from, const glm::vec3& way) { return all.hit(from, way); };
  const solid_hit<float> below = along(s, {0, 1, 0}, {0, -0.5F, 0});
  CHECK(below.distance == 4.0F);
  CHECK(below.normal == glm::vec3(0, 1, 0));
  CHECK(below.colour == s.ground);
  CHECK_FALSE(is_hit(along(s, {0, 1, 0}, {0, 0.5F, 0})));
  CHECK_FALSE(is_hit(along(s, {0, 1, 0}, {1, 0, 0})));
  CHECK_FALSE(is_hit(along(s, {0, -2, 0}, {0, -1, 0})));
  CHECK_FALSE(is_hit(along(s, {0, 1, 0}, {1, -1e-39F, 0})));
  CHECK_FALSE(is_hit(along({}, {0, 1, 0}, {0, -1, 0})));
}

/// Strands of two points from the given roots.
hair_model hair_on(const std::vector<glm::vec3>& roots) {
  std::vector<std::vector<glm::vec3>> lines;
  for (const glm::vec3& root : roots)
    lines.push_back({root, root + glm::vec3(0.0F, 0.1F, 0.0F)});
  return model_of(lines, 0.01F, 1.0F);
}

glm::vec3 point_in_box(random_stream& random) {
  const float x = random.between(-1.0F, 1.0F);
  const float y = random.between(-1.0F, 1.0F);
  return {x, y, random.between(-1.0F, 1.0F)};
}

TEST_CASE("a head is found under the roots that grow on it, and leaves them outside") {
  holds("centre and radius of a noisy scalp", [] {
    const float radius = std::pow(10.0F, any_float(-2.0F, 2.0F));
    const glm::vec3 centre = radius * any_vec3(-3.0F, 3.0F);
    random_stream random(*rc::gen::arbitrary<std::uint64_t>(), 0);
    std::vector<glm::vec3> roots;
    std::vector<std::vector<glm::vec3>> lines(1);  // a strand without points has no root
    while (roots.size() < 300) {
      const glm::vec3 towards = glm::normalize(point_in_box(random) + glm::vec3(0.0F, 1.0F, 0.0F));
      roots.push_back(centre + radius * random.between(0.98F, 1.02F) * towards);
      lines.push_back({roots.back(), roots.back() + 2.0F * random.unit() * radius * towards});
    }
    const auto head = fit_head(model_of(lines, 0.01F, 1.0F));
    RC_ASSERT(head.has_value());
    RC_ASSERT(glm::length(head->centre - centre) < 0.05F * radius);
    RC_ASSERT(std::abs(head->radii.x / radius - 0.99F) < 0.05F);
    RC_ASSERT((head->radii.x == head->radii.y && head->radii.y == head->radii.z));
    const auto outside =
        std::count_if(roots.begin(), roots.end(), [&](const glm::vec3& root) { return head->level(root) >= 1.0F; });
    RC_ASSERT(outside > 200);
  });
}

TEST_CASE("roots that lie on no head have none") {
  CHECK_FALSE(fit_head({}).has_value());
  CHECK_FALSE(fit_head(hair_on({{1, 2, 3}})).has_value());
  CHECK_FALSE(fit_head(model_of({{{1, 2, 3}}, {{1, 2, 3}}}, 0.01F, 1.0F)).has_value());
  CHECK_FALSE(fit_head(hair_on({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}})).has_value());
  CHECK_FALSE(fit_head(hair_on(std::vector<glm::vec3>(100, glm::vec3(1, 2, 3)))).has_value());
  holds("on a plane or a line, or spread through a box", [] {
    std::vector<glm::vec3> plane;
    std::vector<glm::vec3> line;
    std::vector<glm::vec3> box;
    random_stream random(*rc::gen::arbitrary<std::uint64_t>(), 0);
    const glm::vec3 a = point_in_box(random) + glm::vec3(2.0F, 0.0F, 0.0F);
    const glm::vec3 b = point_in_box(random) + glm::vec3(0.0F, 0.0F, 2.0F);
    for (int i = 0; i < 200; ++i) {
      line.push_back(a * random.between(-1.0F, 1.0F));
      plane.push_back(line.back() + b * random.between(-1.0F, 1.0F));
      box.push_back(point_in_box(random));
    }
    RC_ASSERT(!fit_head(hair_on(line)).has_value());
    RC_ASSERT(!fit_head(hair_on(plane)).has_value());
    RC_ASSERT(!fit_head(hair_on(box)).has_value());
  });
}

TEST_CASE("copies that only moved are met as parts of their own would be, however many") {
  holds("against parts", [] {
    solids one = any_solids();
    one.floor.reset();
    RC_PRE(!one.parts.empty());
    std::vector<placement> places;
    solids apart;
    for (int i = *rc::gen::inRange(1, 30); i > 0; --i) {
      const placement p{
          {20.0F * static_cast<float>(i % 6), any_float(-2.0F, 2.0F) - 20.0F * static_cast<float>(i / 6)}};
      places.push_back(p);
      for (const ellipsoid& part : one.parts)
        apart.parts.push_back({p.to_world(part.centre), part.radii});
    }
    one.set_copies(places);
    const glm::vec3 origin = any_vec3(-150.0F, 150.0F);
    const std::size_t aimed = *rc::gen::inRange<std::size_t>(0, apart.parts.size());
    const glm::vec3 direction = glm::normalize(apart.parts[aimed].centre + any_vec3(-2.0F, 2.0F) - origin);
    const solid_hit<float> hit = one.hit(origin, direction);
    const solid_hit<float> expected = apart.hit(origin, direction);
    RC_ASSERT(is_hit(hit) == is_hit(expected));
    if (!is_hit(hit)) return;
    RC_ASSERT(std::abs(hit.distance - expected.distance) < 0.02F);
    RC_ASSERT(glm::dot(hit.normal, expected.normal) > 0.98F);
  });
}

}  // namespace pelage::test
