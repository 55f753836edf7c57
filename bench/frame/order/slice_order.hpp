// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
#include <vector>

#include "frame/model/hair_model.hpp"
#include "frame/model/strands.hpp"

namespace pelage::frame {

/// Segments in the order of equal depth slices, each in the slice of its farther end: nearest slice first, and by
/// number inside a slice, whatever the order of drawing. [Svoboda §1.3.3] The slices divide the depths of the model's
/// box.
///
/// Depth is measured along the direction from the eye to the middle of the box, as in the thesis. The renderer's camera
/// looks at that middle, so it is the view depth of the frame that the order was made for; another frame may keep the
/// order (slice_sort::is_stale).
struct slice_order {
  std::uint32_t slices = 0;   ///< 0: no order
  glm::vec3 direction{0.0F};  ///< unit, along which depth grows
  float middle = 0.0F;        ///< depth of the box's middle
  float extent = 0.0F;        ///< half the range of depths
  std::vector<std::uint32_t> segments;
  std::vector<std::uint32_t> first;  ///< where each slice begins in `segments`; slices + 1 entries
  std::uint32_t sorts = 0;           ///< how often the order was made
  double sort_seconds = 0.0;         ///< what all of them took

  /// Of a place in the world, [0, slices].
  [[nodiscard]] float position(const glm::vec3& place) const;

  /// Makes the order, if there is none for a direction that is near enough. O(segments), parallel.
  void update(const strands& fibres, const box& bounds, const glm::vec3& toward);
};

}  // namespace pelage::frame
