// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "frame/model/strands.hpp"
#include "frame/scene/lights.hpp"
#include "frame/scene/solids.hpp"
#include "frame/shading/fibre_bsdf.hpp"
#include "frame/shadows/shadow_map.hpp"

namespace pelage::frame {

/// A placed light and, where shadows are drawn, its map.
struct lit {
  light source;
  std::unique_ptr<shadow_map> shadow;
};

/// A place on a segment, and who looks at it.
struct lit_place {
  std::uint32_t segment;
  float along;
  glm::vec3 to_eye;  ///< unit
};

/// Everything that light meets, and what comes back to an eye.
struct scene {
  const strands& fibres;
  solids opaque;
  std::vector<lit> lights;
  sphere bounds;  ///< of the fibres
  glm::vec3 sky;  ///< radiance from all sides, linear RGB
  fibre_bsdf bsdf;
  map_lookup lookup = map_lookup::filtered;  ///< of fibres in the lights' maps
  glm::vec3 ambient{0.0F};                   ///< the same of a light that nothing shadows and no background shows

  /// Radiance of a fibre toward `to_eye` (unit) at a place on a segment, linear RGB.
  [[nodiscard]] glm::vec3 fibre_radiance(std::uint32_t segment, float along, const glm::vec3& to_eye) const;

  /// Of many places: what the maps hold of them is loaded meanwhile. Each has the bits that it has alone.
  void fibre_radiance(std::span<const lit_place> places, std::span<glm::vec3> radiance) const;

  /// What rays see that meet no fibre, as many as there are lanes: opaque objects or the background.
  struct backdrop_rays {
    wide depth;  ///< in lengths of the rays' directions; +inf: the background
    wide3 radiance;
  };
  [[nodiscard]] backdrop_rays seen_behind(const wide_rays& rays) const;

 private:
  [[nodiscard]] wide3 solid_radiance(const wide3& position, const solid_hit<wide>& hit, std::uint32_t set) const;
  [[nodiscard]] wide3 background(const wide3& direction) const;

  struct places;
  [[nodiscard]] places places_at(std::span<const lit_place> at) const;

  /// Adds what the places send of a light.
  void light(const lit& l, std::span<places> all) const;
};

}  // namespace pelage::frame
