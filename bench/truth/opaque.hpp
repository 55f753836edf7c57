// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <limits>

#include "frame/scene/solids.hpp"
#include "truth/fibre_rays.hpp"

namespace pelage::truth {

/// A ray's first opaque surface.
struct opaque_hit {
  double distance = std::numeric_limits<double>::infinity();
  glm::dvec3 normal{0.0};       ///< unit, outward, of the surface
  glm::dvec3 soft_normal{0.0};  ///< unit, for shading: rounded over the seams between ellipsoids
  glm::dvec3 colour{0.0};       ///< linear RGB reflectance
  double haze = 0;              ///< share of the background that hides the floor, [0, 1]
  int object = -1;              ///< an ellipsoid's number, then the floor's; -1: none

  [[nodiscard]] bool exists() const { return object >= 0; }
};

/// The scene's ellipsoids and floor met by single rays in double precision. Ellipsoids that a ray starts inside, and
/// a floor that it starts below, are not met.
[[nodiscard]] opaque_hit find_opaque(const frame::solids& opaque, const ray& r);

/// Whether any lies on the ray before its end.
[[nodiscard]] bool is_blocked(const frame::solids& opaque, const ray& r);

}  // namespace pelage::truth
