// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
#include <memory>
#include <vector>

#include "frame/fibre_bsdf.hpp"
#include "frame/lights.hpp"
#include "frame/shadow_map.hpp"
#include "frame/solids.hpp"
#include "frame/strands.hpp"

namespace pelage::frame {

/// A placed light and, where shadows are drawn, its map.
struct lit {
  light source;
  std::unique_ptr<shadow_map> shadow;
};

/// Everything that light meets, and what comes back to an eye.
struct scene {
  const strands& fibres;
  solids opaque;
  std::vector<lit> lights;
  sphere bounds;  ///< of the fibres
  glm::vec3 sky;  ///< radiance from all sides, linear RGB
  fibre_bsdf bsdf;

  /// Radiance of a fibre toward `to_eye` (unit) at a place on a segment, linear RGB.
  [[nodiscard]] glm::vec3 fibre_radiance(std::uint32_t segment, float along, const glm::vec3& to_eye) const;

  /// Prepares fibre_radiance() at a position: see shadow_map::prefetch().
  void prefetch(const glm::vec3& position, int step) const {
    for (const lit& l : lights) {
      if (l.shadow) l.shadow->prefetch(position, step);
    }
  }

  /// Radiance of an opaque object where a ray hits it.
  [[nodiscard]] glm::vec3 solid_radiance(const glm::vec3& position, const solid_hit& hit) const;

  /// What a ray that misses everything sees.
  [[nodiscard]] glm::vec3 background(const glm::vec3& direction) const;
};

}  // namespace pelage::frame
