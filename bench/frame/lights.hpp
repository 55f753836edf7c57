// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "frame/view.hpp"

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

/// What arrives at a point from a light, shadows apart.
struct arrival {
  glm::vec3 to_light;  ///< unit
  glm::vec3 colour;    ///< linear RGB
};

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

/// What arrives at `at` from a placed light.
[[nodiscard]] arrival light_at(const light& placed, const sphere& scene, const glm::vec3& at);

/// The view of a placed light that holds the sphere of the fibres and little else, texels × texels.
/// Throws std::invalid_argument for a point or spot light inside the sphere: one frustum cannot hold it.
[[nodiscard]] view light_view(const light& placed, const sphere& fibres, int texels);

}  // namespace pelage::frame
