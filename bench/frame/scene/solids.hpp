// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "frame/model/ellipsoid.hpp"
#include "frame/model/hair_model.hpp"
#include "frame/model/placement.hpp"

namespace pelage::frame {

/// A point on an opaque object; as many as Real has lanes.
template <class Real>
struct solid_hit {
  Real distance;             ///< in lengths of the ray's direction, > 0; +inf: none, and the rest is garbage
  glm::vec<3, Real> normal;  ///< unit, outward
  glm::vec<3, Real> colour;  ///< linear RGB reflectance
  Real haze;                 ///< share of the background that hides it, [0, 1]: the floor has no horizon
};

/// Holds the parts of a body, and what is near enough for their normals to count; or several bodies' spheres.
struct body_sphere {
  glm::vec3 centre{0.0F};
  float radius = 0.0F;

  static body_sphere round(std::span<const ellipsoid> parts);
  static body_sphere round(std::span<const body_sphere> bodies);

  /// False where a ray's line passes the sphere by. direction is not zero.
  template <class Real>
  [[nodiscard]] auto is_met(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction) const {
    const glm::vec<3, Real> from = origin - filled<Real>(centre);
    const Real along = dot_product(from, direction);
    const Real missed2 = dot_product(from, from) - along * along / dot_product(direction, direction);
    return missed2 < Real(radius * radius);
  }

  template <class Real>
  [[nodiscard]] auto holds(const glm::vec<3, Real>& p) const {
    const glm::vec<3, Real> from = p - filled<Real>(centre);
    return dot_product(from, from) < Real(radius * radius);
  }
};

/// The opaque objects of a scene: ellipsoids, or copies of them that stand apart, and a floor.
struct solids {
  std::vector<ellipsoid> parts;
  std::vector<placement> copies;      ///< of all parts; none: they stand as they are
  std::vector<body_sphere> bodies;    ///< one a copy
  std::vector<body_sphere> clusters;  ///< of cluster_size copies each, in their order, the last of fewer
  std::optional<float> floor;         ///< its height
  float clear = 1.0F;                 ///< distance from a ray's origin up to which the floor is seen as it is
  glm::vec3 skin{0.47F, 0.36F, 0.30F};
  glm::vec3 ground{0.42F, 0.42F, 0.44F};

  static constexpr std::size_t cluster_size = 8;

  /// Puts copies in the place of the parts.
  void set_copies(std::span<const placement> places);

  /// The nearest hit of a ray. direction is not zero.
  template <class Real>
  [[nodiscard]] solid_hit<Real> hit(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction) const;

  /// The length of the unobstructed way from a point on an object's surface, +inf for one that ends nowhere; about 0 or
  /// less for a direction into the object. direction is a unit vector.
  template <class Real>
  [[nodiscard]] Real free_way(const glm::vec<3, Real>& surface, const glm::vec<3, Real>& direction) const;

 private:
  /// Calls `visit(copy)` for the copies whose spheres, and whose clusters' spheres, `meets`.
  template <class Meets, class Visit>
  void for_each_copy(const Meets& meets, const Visit& visit) const;

  /// As first_entry() and hit_ellipsoids(), of all copies.
  template <class Real>
  [[nodiscard]] Real entry(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction, float within) const;
  template <class Real>
  [[nodiscard]] surface_hit<Real> hit_bodies(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction) const;

  /// Down to the floor, in lengths of the ray's direction; +inf: it does not get there.
  template <class Real>
  [[nodiscard]] Real fall(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction) const;
};

/// The sphere that fits the strands' roots best in the sense of least squares, a little shrunk so that roots are on
/// its outside; none when they do not lie on a sphere that a head could be. O(strands).
[[nodiscard]] std::optional<ellipsoid> fit_head(const hair_model& model);

// ---------------------------------------------------------------------------------------------------------

template <class Real>
solid_hit<Real> solids::hit(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction) const {
  const surface_hit<Real> met = hit_bodies(origin, direction);
  const glm::vec<3, Real> flesh = filled<Real>(skin);
  const Real zero(0.0F);
  if (!floor) return {met.distance, met.normal, flesh, zero};
  const Real below = fall(origin, direction);
  const auto on_floor = below < met.distance;
  const Real mist = saturate((below * vector_length(direction) - Real(clear)) / Real(clear));
  const Real haze = mist * mist * (Real(3.0F) - Real(2.0F) * mist);
  return {select(on_floor, below, met.distance), select(on_floor, filled<Real>({0.0F, 1.0F, 0.0F}), met.normal),
          select(on_floor, filled<Real>(ground), flesh), select(on_floor, haze, zero)};
}

template <class Real>
Real solids::free_way(const glm::vec<3, Real>& surface, const glm::vec<3, Real>& direction) const {
  constexpr float rounding = 2e-3F;  // a ray that grazes a part rounded by 2e-6 enters it so far before
  const Real free = entry(surface, direction, rounding);
  return floor ? least(fall(surface, direction), free) : free;
}

template <class Meets, class Visit>
void solids::for_each_copy(const Meets& meets, const Visit& visit) const {
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    if (!meets(clusters[c])) continue;
    for (std::size_t i = c * cluster_size; i < std::min(copies.size(), (c + 1) * cluster_size); ++i)
      if (meets(bodies[i])) visit(copies[i]);
  }
}

template <class Real>
Real solids::entry(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction, float within) const {
  if (copies.empty()) return first_entry<Real>(parts, origin, direction, within);
  Real nearest(std::numeric_limits<float>::infinity());
  for_each_copy([&](const body_sphere& s) { return holds_for_any(s.is_met(origin, direction)); },
                [&](const placement& copy) {
                  const glm::vec<3, Real> from = copy.to_model(origin);
                  nearest = least(first_entry<Real>(parts, from, copy.turned_back(direction), within), nearest);
                });
  return nearest;
}

template <class Real>
surface_hit<Real> solids::hit_bodies(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction) const {
  if (copies.empty()) return hit_ellipsoids<Real>(parts, origin, direction);
  const Real nearest = entry(origin, direction, 0.0F);
  if (!holds_for_any(nearest < Real(std::numeric_limits<float>::infinity()))) return {nearest, {}};
  const glm::vec<3, Real> at = origin + nearest * direction;
  glm::vec<3, Real> sum(Real(0.0F));
  for_each_copy(
      [&](const body_sphere& s) { return holds_for_any(s.holds(at)); },
      [&](const placement& copy) { sum = sum + copy.turned(sum_of_normals<Real>(parts, copy.to_model(at))); });
  return {nearest, unit_vector(sum)};
}

template <class Real>
Real solids::fall(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction) const {
  const Real zero(0.0F);
  const Real height(*floor);
  const Real nowhere(std::numeric_limits<float>::infinity());
  const Real way = (height - origin.y) / direction.y;
  return select(direction.y < zero, select(origin.y > height, way, nowhere), nowhere);
}

}  // namespace pelage::frame
