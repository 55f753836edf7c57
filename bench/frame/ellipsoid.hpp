// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cmath>
#include <optional>
#include <span>

namespace pelage::frame {

/// An ellipsoid with axes along x, y and z. All radii > 0.
struct ellipsoid {
  glm::vec3 centre;
  glm::vec3 radii;

  /// 0 at the centre, 1 on the surface, more outside.
  [[nodiscard]] float level(glm::vec3 p) const { return glm::length((p - centre) / radii); }

  /// Unit outward normal of the level surface through p; p is not the centre.
  [[nodiscard]] glm::vec3 normal(glm::vec3 p) const { return glm::normalize((p - centre) / (radii * radii)); }
};

/// Where a ray meets a surface: origin + distance * direction.
struct surface_hit {
  float distance;    ///< in lengths of the direction, > 0
  glm::vec3 normal;  ///< unit, outward, for shading: rounded over the seams between parts
};

/// The nearest entry of a ray into a union of ellipsoids, those that it starts inside not counted; none if it misses.
/// direction is not zero.
[[nodiscard]] std::optional<surface_hit> hit_ellipsoids(std::span<const ellipsoid> parts, glm::vec3 origin,
                                                        glm::vec3 direction);

/// The normals of the parts whose surfaces pass close to p, a point on one of them, weighted by nearness.
[[nodiscard]] inline glm::vec3 shading_normal(std::span<const ellipsoid> parts, glm::vec3 p) {
  constexpr float reach = 0.12F;
  glm::vec3 sum(0.0F);
  for (const ellipsoid& part : parts) {
    const float nearness = 1.0F - std::abs(part.level(p) - 1.0F) / reach;
    if (nearness > 0.0F) sum += part.normal(p) * (nearness * nearness);
  }
  return glm::normalize(sum);
}

inline std::optional<surface_hit> hit_ellipsoids(std::span<const ellipsoid> parts, glm::vec3 origin,
                                                 glm::vec3 direction) {
  std::optional<surface_hit> nearest;
  for (const ellipsoid& part : parts) {
    const glm::vec3 o = (origin - part.centre) / part.radii;
    const glm::vec3 d = direction / part.radii;
    const float a = glm::dot(d, d);
    const float half_b = glm::dot(o, d);
    const glm::vec3 closest = o - (half_b / a) * d;
    const float depth = 1.0F - glm::dot(closest, closest);
    if (depth <= 0.0F) continue;
    const float t = -half_b / a - std::sqrt(depth / a);
    if (t <= 0.0F || (nearest && nearest->distance <= t)) continue;
    nearest = surface_hit{t, glm::vec3(0.0F)};
  }
  if (nearest) nearest->normal = shading_normal(parts, origin + nearest->distance * direction);
  return nearest;
}

}  // namespace pelage::frame
