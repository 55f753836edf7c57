// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <array>

#include "frame/model/ellipsoid.hpp"

namespace pelage::frame {

/// The opaque body under the built-in hair, a union of ellipsoids: y is up, the face looks along +z, the head
/// is centred at the origin, chin near y = -1 and crown near y = +1 (one unit is about 11.5 cm).
inline constexpr int bust_parts = 4;
inline constexpr std::array<ellipsoid, bust_parts> bust{{
    {{0.00F, 0.22F, -0.06F}, {0.70F, 0.78F, 0.86F}},   // cranium, which bears the hair
    {{0.00F, -0.06F, 0.10F}, {0.60F, 0.94F, 0.68F}},   // face
    {{0.00F, -1.20F, -0.16F}, {0.38F, 1.00F, 0.40F}},  // neck
    {{0.00F, -2.26F, -0.20F}, {1.60F, 0.58F, 0.56F}},  // shoulders
}};

/// True if p is inside a part of the bust or on it.
[[nodiscard]] bool inside_bust(glm::vec3 p);

/// The nearest entry of a ray into the bust, parts that it starts inside not counted; at +inf if it misses.
/// direction is not zero.
[[nodiscard]] surface_hit<float> hit_bust(glm::vec3 origin, glm::vec3 direction);

inline bool inside_bust(glm::vec3 p) {
  for (const ellipsoid& part : bust) {
    if (part.level(p) <= 1.0F) return true;
  }
  return false;
}

inline surface_hit<float> hit_bust(glm::vec3 origin, glm::vec3 direction) {
  return hit_ellipsoids<float>(bust, origin, direction);
}

}  // namespace pelage::frame
