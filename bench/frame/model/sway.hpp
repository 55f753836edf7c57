// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <array>
#include <cstdint>
#include <vector>

#include "frame/model/hair_model.hpp"
#include "frame/model/strands.hpp"

namespace pelage::frame {

/// Where a point of a fibre lies when no wind blows.
struct rest_point {
  glm::vec3 place;
  std::uint32_t root;  ///< the number of its strand's first point
};

/// A wind toward +x at one time: three waves of gusts that travel through space. shaders/sway.glsl has the same, and
/// takes these words.
struct wind {
  std::array<float, 3> phase;  ///< of the waves, turns, [0, 1)
  float bend;                  ///< half the amplitude over the hair's reach, 1 / length
  float scale;                 ///< 1 over the hair's reach, 1 / length

  /// Where a point is in this wind. Its strand bends toward the wind by turning round its root, the more the farther
  /// from there: the root stays to the bit, and but for rounding so does the distance from there, and a point that
  /// rests at distance r from its root moves by less than 2 bend r².
  [[nodiscard]] glm::vec3 moved(const glm::vec3& place, const glm::vec3& root) const;
};

/// Hair that a wind moves: what stays the same at all times.
struct swaying_hair {
  std::vector<rest_point> rest;  ///< empty: it does not move
  float amplitude = 0.0F;        ///< the most that a tip moves, in shares of the reach, [0, 1]
  float reach = 1.0F;            ///< the greatest distance of a point from its root, > 0

  [[nodiscard]] bool moves() const { return !rest.empty(); }

  /// The wind in a frame, 1/30 s after the one before.
  [[nodiscard]] wind wind_at(std::uint32_t frame) const;

  /// A box that holds a point of the hair whatever the wind's time.
  [[nodiscard]] box range_of(const rest_point& p) const;
};

/// `amplitude`: [0, 1]; hair does not move at 0. O(points).
[[nodiscard]] swaying_hair make_swaying(const hair_model& model, float amplitude);

/// A box that holds all points of the model, at rest and whatever the wind's time. O(points).
[[nodiscard]] box bounds_of(const hair_model& model, const swaying_hair& hair);

/// Moves fibres of the model that the hair was made of to where they are in a frame: points, and tangents as
/// prepare_strands() has them. Nothing if the hair does not move. O(points), parallel.
void sway(const swaying_hair& hair, std::uint32_t frame, strands& fibres);

}  // namespace pelage::frame
