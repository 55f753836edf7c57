// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/divided_pixel.hpp>

#include <glm/glm.hpp>
#include <cstddef>
#include <span>
#include <vector>

#include "frame/image/image.hpp"
#include "frame/scene/view.hpp"
#include "frame/shading/scene.hpp"

namespace pelage::frame {

/// What an eye sees where no fibre is: the opaque objects before the background. With anti-aliasing a pixel sees them
/// by 3 × 3 samples, as two surfaces where these lie at different depths.
class backdrop {
 public:
  /// O(pixels), parallel.
  backdrop(const view& eye, const scene& world, bool antialias);

  /// View depth of the farthest opaque sample in each pixel, +inf where one sees none: what is behind is hidden.
  [[nodiscard]] std::span<const float> limit() const { return limit_; }

  /// View depth of the nearer surface in each pixel, divided_backdrop::edge.
  [[nodiscard]] std::span<const float> edge() const { return edge_; }

  [[nodiscard]] divided_backdrop<float> at(std::size_t pixel) const {
    return {edge_[pixel], far_share_[pixel], far_light_[pixel], picture_.pixels[pixel]};
  }
  [[nodiscard]] const image& picture() const { return picture_; }

 private:
  /// The pixels from (x, y) to the right, as many as there are lanes.
  void see(const view& eye, const scene& world, int x, int y);

  int side_;  ///< samples along a pixel's side
  std::vector<float> limit_;
  std::vector<float> edge_;
  std::vector<float> far_share_;
  std::vector<glm::vec3> far_light_;
  image picture_;
};

}  // namespace pelage::frame
