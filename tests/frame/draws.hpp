// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "property.hpp"

#include <glm/vec3.hpp>

/// What rapidcheck draws for the renderer's tests.
namespace pelage::test {

/// Evenly in [lower, upper).
inline float any_float(float lower, float upper) {
  const int part = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1 << 24));
  return lower + (upper - lower) * static_cast<float>(part) * 0x1p-24F;
}

inline glm::vec3 any_vec3(float lower, float upper) {
  const float x = any_float(lower, upper);
  const float y = any_float(lower, upper);
  const float z = any_float(lower, upper);
  return {x, y, z};
}

}  // namespace pelage::test
