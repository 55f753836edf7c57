// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lanes.hpp>

#include <glm/glm.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "frame/raster/fragment_lanes.hpp"
#include "frame/raster/raster.hpp"
#include "frame/shading/scene.hpp"

namespace pelage::frame {

/// The radiance of all fibres toward one eye. Shading is evaluated at the ends of each segment and at places between
/// them, evenly spaced along it and at most a given number of pixels apart on the screen; elsewhere it is mixed from
/// the two places beside. So its cost depends on the fibres' length on the screen, not on how many fragments they
/// leave, and the result not on the order in which those are met. What opaque objects hide is not shaded.
class shaded_fibres {
 public:
  /// `limit`: view depth per pixel at and behind which no fibre is seen, or empty. `spacing`: pixels, (0, inf]; 0:
  /// nothing is mixed, each question is answered by itself. A segment has at most 64 intervals. Both references must
  /// outlive this. O(points), parallel. Throws std::runtime_error where the places would be more than 7 · 10⁸.
  shaded_fibres(const scene& world, const raster& from, std::span<const float> limit, float spacing);

  /// Linear RGB at a place on a segment, where it leaves a fragment before the limit.
  [[nodiscard]] glm::vec3 at(std::uint32_t segment, float along) const;

  /// The same for each of a vector's fragments.
  [[nodiscard]] lane_vector<fragment_lanes::width> at(const fragment_lanes& all) const;

  /// Evaluations that the constructor made.
  [[nodiscard]] std::size_t evaluations() const { return place_.size(); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] std::uint32_t intervals(std::uint32_t segment, float spacing) const;
  void shade(std::uint32_t begin, std::uint32_t end);

  /// Calls `visit(place, segment, along)` for the places of segments [begin, end), in order and without gaps.
  template <class Visit>
  void for_each_place(std::uint32_t begin, std::uint32_t end, Visit&& visit) const;

  [[nodiscard]] lit_place place_on(std::uint32_t segment, float along) const;

  const scene& world_;
  const raster& from_;
  std::vector<std::uint32_t> first_;  ///< per point, its place; those between it and the next point follow
  big_array<glm::vec3> place_;        ///< radiance
};

}  // namespace pelage::frame
