// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "frame/draws.hpp"
#include "frame/order/layer.hpp"

namespace pelage::test {

using namespace frame;

using layers = std::vector<layer>;

inline layer any_layer(std::uint32_t id, float depth, float alpha) {
  return {{depth, id}, alpha, any_vec3(0.0F, 2.0F)};
}

inline layers any_layers(int most) {
  layers all;
  const auto count = static_cast<std::uint32_t>(*rc::gen::inRange(1, most + 1));
  for (std::uint32_t id = 0; id < count; ++id)
    all.push_back(any_layer(id, any_float(1.0F, 9.0F), any_float(0.0F, 1.0F)));
  return all;
}

/// Layer over layer, nearest first.
inline glm::dvec3 over_all(layers all, const glm::vec3& background) {
  std::sort(all.begin(), all.end(), [](const layer& a, const layer& b) { return before(a.where, b.where); });
  glm::dvec3 sum(0.0);
  double passed = 1.0;
  for (const layer& l : all) {
    sum += passed * static_cast<double>(l.alpha) * glm::dvec3(l.radiance);
    passed *= 1.0 - static_cast<double>(l.alpha);
  }
  return sum + passed * glm::dvec3(background);
}

inline bool near(const glm::vec3& a, const glm::dvec3& b, double error) {
  return glm::length(glm::dvec3(a) - b) < error;
}

}  // namespace pelage::test
