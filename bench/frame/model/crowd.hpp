// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "frame/model/ellipsoid.hpp"
#include "frame/model/hair_model.hpp"
#include "frame/model/placement.hpp"
#include "frame/model/sway.hpp"

namespace pelage::frame {

/// The upright cylinder, its axis through the middle of the model's box, that holds the axes of its fibres and what
/// they stand on.
struct upright_bounds {
  glm::vec2 axis;  ///< x and z
  float radius;
  float lower, upper;  ///< y

  /// Of the points, wherever a wind takes them, and the parts; of neither, of radius 0 round the origin. O(points).
  static upright_bounds of(const hair_model& model, const swaying_hair& hair, std::span<const ellipsoid> parts);
};

/// Where n copies of a model stand: in rows that are shifted by half a place against each other, as wide as the picture
/// asks, every copy turned and a little moved by a hash of its number. Neighbours in space are near each other in the
/// list. Axes are at least 0.98 diameters apart. One copy is as it is.
/// `aspect`: the picture's width over its height, (0, inf).
[[nodiscard]] std::vector<placement> crowd_places(std::uint32_t n, const upright_bounds& one, float aspect);

/// The box of all copies' cylinders.
[[nodiscard]] box crowd_bounds(std::span<const placement> copies, const upright_bounds& one);

}  // namespace pelage::frame
