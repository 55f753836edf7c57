// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/ray_cone.hpp>

#include <glm/glm.hpp>

#include "frame/base/wide.hpp"

namespace pelage::frame {

/// A rectangle of pixels, [x0, x1) × [y0, y1).
struct pixel_rect {
  int x0, y0, x1, y1;
};

/// A ray in view space whose direction has z = -1, so that a position along it is a view depth.
struct view_ray {
  glm::vec3 origin;
  glm::vec3 direction;
};

/// The same rays in the world, as many as there are lanes.
struct wide_rays {
  wide3 origin;
  wide3 direction;
};

/// Where a picture is taken from, by a camera or by a light: a frame in space, a projection and a grid of pixels.
/// View space has the eye at its origin and looks along -z with y up; pixel (0, 0) is at the top left and its centre
/// at (0.5, 0.5). Square pixels.
struct view {
  glm::mat3 rotation;    ///< world directions to view directions
  glm::vec3 eye;         ///< world position of the view's origin
  bool perspective;      ///< or orthographic
  float scale;           ///< perspective: pixels per unit of tangent; orthographic: pixels per unit of length
  float near_plane;      ///< view depth from which on fibres are drawn
  int width, height;     ///< pixels
  ray_cone<float> cone;  ///< of one pixel

  [[nodiscard]] glm::vec3 to_view(const glm::vec3& world) const { return rotation * (world - eye); }
  [[nodiscard]] wide3 to_view(const wide3& world) const {
    const wide3 d = world - filled<wide>(eye);
    const auto row = [&](int i) {
      return wide(rotation[0][i]) * d.x + wide(rotation[1][i]) * d.y + wide(rotation[2][i]) * d.z;
    };
    return {row(0), row(1), row(2)};
  }
  [[nodiscard]] glm::vec3 direction_to_world(const glm::vec3& d) const { return glm::transpose(rotation) * d; }
  [[nodiscard]] wide3 direction_to_world(const wide3& d) const {
    const auto column = [&](int i) {
      return wide(rotation[i].x) * d.x + wide(rotation[i].y) * d.y + wide(rotation[i].z) * d.z;
    };
    return {column(0), column(1), column(2)};
  }

  /// Pixel coordinates of a point in view space; a point nearer than the near plane is taken to lie on it.
  [[nodiscard]] glm::vec2 to_pixel(const glm::vec3& p) const {
    const float depth = -p.z > near_plane ? -p.z : near_plane;
    const float s = perspective ? scale / depth : scale;
    return {0.5F * static_cast<float>(width) + s * p.x, 0.5F * static_cast<float>(height) - s * p.y};
  }

  [[nodiscard]] glm::vec<2, wide> to_pixel(const wide3& p) const {
    const wide ahead = wide(0.0F) - p.z;
    const wide s = perspective ? wide(scale) / greatest(ahead, wide(near_plane)) : wide(scale);
    return {wide(0.5F * static_cast<float>(width)) + s * p.x, wide(0.5F * static_cast<float>(height)) - s * p.y};
  }

  /// The ray through pixel coordinates.
  [[nodiscard]] view_ray ray(const glm::vec2& pixel) const {
    const glm::vec3 across((pixel.x - 0.5F * static_cast<float>(width)) / scale,
                           (0.5F * static_cast<float>(height) - pixel.y) / scale, 0.0F);
    const glm::vec3 ahead(0.0F, 0.0F, -1.0F);
    return perspective ? view_ray{glm::vec3(0.0F), across + ahead} : view_ray{across, ahead};
  }
  [[nodiscard]] wide_rays world_rays(wide x, wide y) const {
    const wide zero(0.0F);
    const wide3 across((x - wide(0.5F * static_cast<float>(width))) / wide(scale),
                       (wide(0.5F * static_cast<float>(height)) - y) / wide(scale), zero);
    const wide3 ahead(zero, zero, wide(-1.0F));
    const wide3 from = filled<wide>(eye);
    if (perspective) return {from, direction_to_world(across + ahead)};
    return {from + direction_to_world(across), direction_to_world(ahead)};
  }
};

/// A perspective view from `eye` toward `target`. `tan_half_fov`: of the vertical field, (0, inf).
[[nodiscard]] view perspective_view(const glm::vec3& eye, const glm::vec3& target, float tan_half_fov, int width,
                                    int height, float near_plane);

/// An orthographic view along `direction` that shows the square of side `extent` round `target`, texels × texels.
/// Its eye stands one extent before the target.
[[nodiscard]] view orthographic_view(const glm::vec3& target, const glm::vec3& direction, float extent, int texels);

}  // namespace pelage::frame
