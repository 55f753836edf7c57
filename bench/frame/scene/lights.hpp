// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/vector_math.hpp>

#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "frame/base/wide.hpp"
#include "frame/scene/view.hpp"

namespace pelage::frame {

enum class light_kind { directional, point, spot };

/// A light of the scene.
struct light {
  light_kind kind;
  glm::vec3 position;   ///< of point and spot lights, in radii of the scene round its centre
  glm::vec3 direction;  ///< unit, the way that directional and spot light travels
  glm::vec3 colour;     ///< linear RGB radiance of a white wall at the scene's centre that faces it
  float cos_outer = 0;  ///< spot: cosine of the half angle where it ends,
  float cos_inner = 0;  ///< and where it begins to fade
};

/// How far a point lies from a placed light; of a directional one the greatest float.
template <class Real>
[[nodiscard]] Real distance_to(const light& placed, const glm::vec<3, Real>& at) {
  if (placed.kind == light_kind::directional) return Real(std::numeric_limits<float>::max());
  return vector_length(filled<Real>(placed.position) - at);
}

/// What arrives at a point from a light, shadows apart; at as many points as Real has lanes.
template <class Real>
struct arrival_of {
  glm::vec<3, Real> to_light;  ///< unit
  glm::vec<3, Real> colour;    ///< linear RGB
};
using arrival = arrival_of<float>;

/// A sphere round all that is drawn.
struct sphere {
  glm::vec3 centre;
  float radius;
};

/// Reads "directional:X,Y,Z:R,G,B", "point:X,Y,Z:R,G,B" or "spot:X,Y,Z:R,G,B:DEGREES". X, Y, Z is where the light is,
/// seen from the scene's centre, in radii of the scene (of a directional light the direction alone counts); spots
/// point at the centre with the given full angle. Throws std::invalid_argument with one line that says what is wrong.
[[nodiscard]] light parse_light(const std::string& text);

/// `lights` placed in a scene: positions in the scene's own units.
[[nodiscard]] light place_light(const light& relative, const sphere& scene);

/// What arrives at `at` from a placed light. Each lane gets the bits that its point gets alone.
template <class Real>
[[nodiscard]] arrival_of<Real> light_at(const light& placed, const sphere& scene, const glm::vec<3, Real>& at);

/// The view of a placed light that holds the sphere of the fibres and little else, texels × texels.
/// Throws std::invalid_argument for a point or spot light inside the sphere: one frustum cannot hold it.
[[nodiscard]] view light_view(const light& placed, const sphere& fibres, int texels);

// ---------------------------------------------------------------------------------------------------------

template <class Real>
arrival_of<Real> light_at(const light& placed, const sphere& scene, const glm::vec<3, Real>& at) {
  if (placed.kind == light_kind::directional) {
    return {filled<Real>(-placed.direction), filled<Real>(placed.colour)};
  }
  const glm::vec<3, Real> way = filled<Real>(placed.position) - at;
  const glm::vec3 centre_way = placed.position - scene.centre;
  const Real distance2 = greatest(dot_product(way, way), Real(1e-30F));
  const glm::vec<3, Real> to_light = way / square_root(distance2);
  Real strength = Real(dot_product(centre_way, centre_way)) / distance2;
  if (placed.kind == light_kind::spot) {
    const Real inside = Real(0.0F) - dot_product(to_light, filled<Real>(placed.direction));
    const Real share = saturate((inside - Real(placed.cos_outer)) / Real(placed.cos_inner - placed.cos_outer));
    strength = strength * (share * share * (Real(3.0F) - Real(2.0F) * share));
  }
  return {to_light, strength * filled<Real>(placed.colour)};
}

}  // namespace pelage::frame
