// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <glm/vec3.hpp>

namespace pelage::frame {

/// A fragment as a pixel blends it.
struct layer {
  fragment where;
  float alpha;         ///< opacity times coverage, [0, 1]
  glm::vec3 radiance;  ///< toward the eye, linear RGB
};

}  // namespace pelage::frame
