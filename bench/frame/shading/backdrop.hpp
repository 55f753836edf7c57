// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cstddef>
#include <span>
#include <vector>

#include "frame/image/image.hpp"
#include "frame/scene/view.hpp"
#include "frame/shading/scene.hpp"

namespace pelage::frame {

/// What an eye sees where no fibre is: the opaque objects before the background. With anti-aliasing a pixel sees them
/// by 3 × 3 samples.
class backdrop {
 public:
  /// O(pixels), parallel.
  backdrop(const view& eye, const scene& world, bool antialias);

  /// View depth of the farthest opaque sample in each pixel, +inf where one sees none: what is behind is hidden.
  [[nodiscard]] std::span<const float> limit() const { return limit_; }

  /// The share of a pixel's samples that a view depth lies in front of, [0, 1].
  [[nodiscard]] float share_behind(std::size_t pixel, float depth) const;

  [[nodiscard]] const image& picture() const { return picture_; }

 private:
  /// The pixels from (x, y) to the right, as many as there are lanes.
  void see(const view& eye, const scene& world, int x, int y);

  int side_;                         ///< samples along a pixel's side
  std::vector<float> sample_depth_;  ///< side² a pixel
  std::vector<float> nearest_;       ///< the least of them
  std::vector<float> limit_;         ///< the greatest
  image picture_;
};

}  // namespace pelage::frame
