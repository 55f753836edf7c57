// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/vector_math.hpp>

#include <glm/glm.hpp>
#include <limits>
#include <span>

#include "frame/base/wide.hpp"

namespace pelage::frame {

/// An ellipsoid with axes along x, y and z. All radii > 0.
struct ellipsoid {
  glm::vec3 centre;
  glm::vec3 radii;

  /// 0 at the centre, 1 on the surface, more outside.
  template <class Real>
  [[nodiscard]] Real level(const glm::vec<3, Real>& p) const {
    return vector_length((p - filled<Real>(centre)) / filled<Real>(radii));
  }

  /// Unit outward normal of the level surface through p; p is not the centre.
  template <class Real>
  [[nodiscard]] glm::vec<3, Real> normal(const glm::vec<3, Real>& p) const {
    return unit_vector((p - filled<Real>(centre)) / filled<Real>(radii * radii));
  }
};

/// Where a ray meets a surface: origin + distance * direction; where as many rays do as Real has lanes.
template <class Real>
struct surface_hit {
  Real distance;             ///< in lengths of the direction, > 0; +inf: nowhere
  glm::vec<3, Real> normal;  ///< unit, outward, for shading: rounded over the seams between parts; or garbage
};

/// Where a ray first enters a part, in lengths of its direction; +inf: nowhere. Entries count that lie at most `within`
/// of a part's first radius before the origin: with 0 the ray may start inside parts, with a little a ray from a point
/// on a part's surface into it enters there, however the point was rounded. direction is not zero.
template <class Real>
[[nodiscard]] Real first_entry(std::span<const ellipsoid> parts, const glm::vec<3, Real>& origin,
                               const glm::vec<3, Real>& direction, float within = 0.0F);

/// The nearest entry of a ray into a union of ellipsoids, those that it starts inside not counted.
/// direction is not zero.
template <class Real>
[[nodiscard]] surface_hit<Real> hit_ellipsoids(std::span<const ellipsoid> parts, const glm::vec<3, Real>& origin,
                                               const glm::vec<3, Real>& direction);

// ---------------------------------------------------------------------------------------------------------

/// The normals of the parts whose surfaces pass close to p, weighted by nearness and summed.
template <class Real>
[[nodiscard]] glm::vec<3, Real> sum_of_normals(std::span<const ellipsoid> parts, const glm::vec<3, Real>& p) {
  constexpr float reach = 0.12F;
  const glm::vec<3, Real> none(Real(0.0F));
  glm::vec<3, Real> sum = none;
  for (const ellipsoid& part : parts) {
    const Real nearness = Real(1.0F) - absolute(part.level(p) - Real(1.0F)) / Real(reach);
    sum = sum + select(nearness > Real(0.0F), part.normal(p) * (nearness * nearness), none);
  }
  return sum;
}

template <class Real>
Real first_entry(std::span<const ellipsoid> parts, const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction,
                 float within) {
  const Real zero(0.0F);
  const Real nowhere(std::numeric_limits<float>::infinity());
  Real nearest = nowhere;
  for (const ellipsoid& part : parts) {
    const glm::vec<3, Real> o = (origin - filled<Real>(part.centre)) / filled<Real>(part.radii);
    const glm::vec<3, Real> d = direction / filled<Real>(part.radii);
    const Real a = dot_product(d, d);
    const Real middle = dot_product(o, d) / a;
    const glm::vec<3, Real> closest = o - middle * d;
    const Real depth = Real(1.0F) - dot_product(closest, closest);
    const Real t = zero - middle - square_root(depth / a);
    const Real entry = select(depth > zero, select(t > Real(-within * part.radii.x), t, nowhere), nowhere);
    nearest = least(entry, nearest);
  }
  return nearest;
}

template <class Real>
surface_hit<Real> hit_ellipsoids(std::span<const ellipsoid> parts, const glm::vec<3, Real>& origin,
                                 const glm::vec<3, Real>& direction) {
  const Real nearest = first_entry(parts, origin, direction);
  if (!holds_for_any(nearest < Real(std::numeric_limits<float>::infinity()))) return {nearest, {}};
  return {nearest, unit_vector(sum_of_normals(parts, origin + nearest * direction))};
}

}  // namespace pelage::frame
