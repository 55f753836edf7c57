// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "frame/ellipsoid.hpp"
#include "frame/hair_model.hpp"

namespace pelage::frame {

/// A point on an opaque object.
struct solid_hit {
  float distance;    ///< in lengths of the ray's direction, > 0
  glm::vec3 normal;  ///< unit, outward
  glm::vec3 colour;  ///< linear RGB reflectance
  float haze;        ///< share of the background that hides it, [0, 1]: the floor has no horizon
};

/// The opaque objects of a scene: ellipsoids and a floor.
struct solids {
  std::vector<ellipsoid> parts;
  std::optional<float> floor;  ///< its height
  float clear = 1.0F;          ///< distance from a ray's origin up to which the floor is seen as it is
  glm::vec3 skin{0.47F, 0.36F, 0.30F};
  glm::vec3 ground{0.42F, 0.42F, 0.44F};

  /// The nearest hit of a ray. direction is not zero.
  [[nodiscard]] std::optional<solid_hit> hit(const glm::vec3& origin, const glm::vec3& direction) const;
};

/// The sphere that fits the strands' roots best in the sense of least squares, a little shrunk so that roots are on
/// its outside; none when they do not lie on a sphere that a head could be. O(strands).
[[nodiscard]] std::optional<ellipsoid> fit_head(const hair_model& model);

}  // namespace pelage::frame
