// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/view.hpp"

#include <cmath>
#include <limits>

namespace pelage::frame {
namespace {

glm::mat3 look_along(const glm::vec3& direction) {
  const glm::vec3 back = -glm::normalize(direction);
  const glm::vec3 up = std::abs(back.y) > 0.999F ? glm::vec3(0.0F, 0.0F, -1.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  const glm::vec3 right = glm::normalize(glm::cross(up, back));
  return glm::transpose(glm::mat3(right, glm::cross(back, right), back));
}

}  // namespace

view perspective_view(const glm::vec3& eye, const glm::vec3& target, float tan_half_fov, int width, int height,
                      float near_plane, pixel_footprint footprint) {
  return view{look_along(target - eye),
              eye,
              true,
              0.5F * static_cast<float>(height) / tan_half_fov,
              near_plane,
              width,
              height,
              perspective_cone(tan_half_fov, height, footprint),
              std::numeric_limits<float>::infinity()};
}

view orthographic_view(const glm::vec3& target, const glm::vec3& direction, float extent, int texels,
                       pixel_footprint footprint) {
  return view{look_along(direction),
              target - extent * glm::normalize(direction),
              false,
              static_cast<float>(texels) / extent,
              0.0F,
              texels,
              texels,
              orthographic_cone(extent, texels, footprint),
              2.0F * extent};
}

}  // namespace pelage::frame
