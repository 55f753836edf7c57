// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "frame/base/random.hpp"

namespace pelage::frame {

upright_bounds upright_bounds::of(const hair_model& model, const swaying_hair& hair, std::span<const ellipsoid> parts) {
  box all = bounds_of(model, hair);
  for (const ellipsoid& part : parts) {
    all.lower = glm::min(all.lower, part.centre - part.radii);
    all.upper = glm::max(all.upper, part.centre + part.radii);
  }
  if (all.empty()) return {glm::vec2(0.0F), 0.0F, 0.0F, 0.0F};
  const glm::vec2 axis = 0.5F * glm::vec2(all.lower.x + all.upper.x, all.lower.z + all.upper.z);
  float radius = 0.0F;
  for (const glm::vec3& p : model.points)
    radius = std::max(radius, glm::length(glm::vec2(p.x, p.z) - axis));
  for (const rest_point& p : hair.rest) {
    const box range = hair.range_of(p);
    const glm::vec2 lower(range.lower.x, range.lower.z);
    const glm::vec2 upper(range.upper.x, range.upper.z);
    radius = std::max(radius, glm::length(glm::max(glm::abs(lower - axis), glm::abs(upper - axis))));
  }
  for (const ellipsoid& part : parts) {
    const float aside = glm::length(glm::vec2(part.centre.x, part.centre.z) - axis);
    radius = std::max(radius, aside + std::max(part.radii.x, part.radii.z));
  }
  return {axis, radius, all.lower.y, all.upper.y};
}

std::vector<placement> crowd_places(std::uint32_t n, const upright_bounds& one, float aspect) {
  if (n == 1) return {placement{}};
  constexpr float room = 1.08F;    // between neighbours, in diameters
  constexpr float stirs = 0.035F;  // either way, in diameters: 1.08 - 2 √2 · 0.035 > 0.98
  constexpr float row_height = 0.8660254F;
  const float spacing = room * 2.0F * one.radius;
  constexpr float seen_height = 0.6F;  // of a place from above, in the default view
  const auto across =
      std::max(1U, static_cast<std::uint32_t>(std::lround(std::sqrt(seen_height * static_cast<float>(n) * aspect))));
  std::vector<std::uint32_t> number(n);
  std::iota(number.begin(), number.end(), 0U);
  const auto block = [&](std::uint32_t i) { return i / across / 2 * across + i % across / 4; };
  std::stable_sort(number.begin(), number.end(), [&](auto a, auto b) { return block(a) < block(b); });
  std::vector<placement> all(n);
  std::transform(number.begin(), number.end(), all.begin(), [&](std::uint32_t i) {
    random_stream random(0, i);
    const std::uint32_t row = i / across;
    const float shift = row % 2 == 1 ? 0.5F : 0.0F;
    const float angle = random.between(-0.7F, 0.7F);
    placement p{glm::vec2(0.0F), std::cos(angle), std::sin(angle)};
    const glm::vec2 place(spacing * (static_cast<float>(i % across) + shift),
                          -spacing * row_height * static_cast<float>(row));
    const float stir_x = random.between(-stirs, stirs);
    const glm::vec2 stir(stir_x, random.between(-stirs, stirs));
    const glm::vec3 axis = p.turned(glm::vec3(one.axis.x, 0.0F, one.axis.y));
    p.at = place + 2.0F * one.radius * stir - glm::vec2(axis.x, axis.z);
    return p;
  });
  return all;
}

box crowd_bounds(std::span<const placement> copies, const upright_bounds& one) {
  box all;
  for (const placement& p : copies) {
    const glm::vec3 axis = p.to_world(glm::vec3(one.axis.x, 0.0F, one.axis.y));
    all.lower = glm::min(all.lower, glm::vec3(axis.x - one.radius, one.lower, axis.z - one.radius));
    all.upper = glm::max(all.upper, glm::vec3(axis.x + one.radius, one.upper, axis.z + one.radius));
  }
  return all;
}

}  // namespace pelage::frame
