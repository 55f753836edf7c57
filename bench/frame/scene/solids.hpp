// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "frame/model/ellipsoid.hpp"
#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// A point on an opaque object; as many as Real has lanes.
template <class Real>
struct solid_hit {
  Real distance;             ///< in lengths of the ray's direction, > 0; +inf: none, and the rest is garbage
  glm::vec<3, Real> normal;  ///< unit, outward
  glm::vec<3, Real> colour;  ///< linear RGB reflectance
  Real haze;                 ///< share of the background that hides it, [0, 1]: the floor has no horizon
};

/// The opaque objects of a scene: ellipsoids and a floor.
struct solids {
  std::vector<ellipsoid> parts;
  std::optional<float> floor;  ///< its height
  float clear = 1.0F;          ///< distance from a ray's origin up to which the floor is seen as it is
  glm::vec3 skin{0.47F, 0.36F, 0.30F};
  glm::vec3 ground{0.42F, 0.42F, 0.44F};

  /// The nearest hit of a ray. direction is not zero.
  template <class Real>
  [[nodiscard]] solid_hit<Real> hit(const glm::vec<3, Real>& origin, const glm::vec<3, Real>& direction) const;

  /// The length of the unobstructed way from a point on an object's surface, +inf for one that ends nowhere; about 0 or
  /// less for a direction into the object. direction is a unit vector.
  template <class Real>
  [[nodiscard]] Real free_way(const glm::vec<3, Real>& surface, const glm::vec<3, Real>& direction) const;

 private:
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
  const surface_hit<Real> body = hit_ellipsoids<Real>(parts, origin, direction);
  const glm::vec<3, Real> flesh = filled<Real>(skin);
  const Real zero(0.0F);
  if (!floor) return {body.distance, body.normal, flesh, zero};
  const Real below = fall(origin, direction);
  const auto on_floor = below < body.distance;
  const Real mist = saturate((below * vector_length(direction) - Real(clear)) / Real(clear));
  const Real haze = mist * mist * (Real(3.0F) - Real(2.0F) * mist);
  return {select(on_floor, below, body.distance), select(on_floor, filled<Real>({0.0F, 1.0F, 0.0F}), body.normal),
          select(on_floor, filled<Real>(ground), flesh), select(on_floor, haze, zero)};
}

template <class Real>
Real solids::free_way(const glm::vec<3, Real>& surface, const glm::vec<3, Real>& direction) const {
  constexpr float rounding = 2e-3F;  // a ray that grazes a part rounded by 2e-6 enters it so far before
  const Real free = first_entry<Real>(parts, surface, direction, rounding);
  return floor ? least(fall(surface, direction), free) : free;
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
