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

/// A ray whose direction has z = -1 in view space, so that a position along it is a view depth. Real: float, or a pack
/// of floats for as many rays.
template <class Real>
struct ray_from {
  glm::vec<3, Real> origin;
  glm::vec<3, Real> direction;
};
using view_ray = ray_from<float>;
using wide_rays = ray_from<wide>;

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
  float far_depth;       ///< view depth up to which a light's fibres lie, at least about; +inf: not known

  /// The radius of a pixel's disc in pixels.
  [[nodiscard]] float disc() const { return (cone.base + cone.slope) * scale; }

  // Real: float, or a pack of floats for as many points.

  template <class Real>
  [[nodiscard]] glm::vec<3, Real> to_view(const glm::vec<3, Real>& world) const {
    return direction_to_view(world - filled<Real>(eye));
  }

  template <class Real>
  [[nodiscard]] glm::vec<3, Real> direction_to_view(const glm::vec<3, Real>& d) const {
    const auto row = [&](int i) {
      return Real(rotation[0][i]) * d.x + Real(rotation[1][i]) * d.y + Real(rotation[2][i]) * d.z;
    };
    return {row(0), row(1), row(2)};
  }

  template <class Real>
  [[nodiscard]] glm::vec<3, Real> direction_to_world(const glm::vec<3, Real>& d) const {
    const auto column = [&](int i) {
      return Real(rotation[i].x) * d.x + Real(rotation[i].y) * d.y + Real(rotation[i].z) * d.z;
    };
    return {column(0), column(1), column(2)};
  }

  /// Pixel coordinates of a point in view space; a point nearer than the near plane is taken to lie on it.
  template <class Real>
  [[nodiscard]] glm::vec<2, Real> to_pixel(const glm::vec<3, Real>& p) const {
    const Real s = perspective ? Real(scale) / greatest(Real(0.0F) - p.z, Real(near_plane)) : Real(scale);
    return {Real(0.5F * static_cast<float>(width)) + s * p.x, Real(0.5F * static_cast<float>(height)) - s * p.y};
  }

  /// A pixel's width at a point in view space, length units.
  template <class Real>
  [[nodiscard]] Real pixel_at(const glm::vec<3, Real>& p) const {
    return perspective ? greatest(Real(0.0F) - p.z, Real(near_plane)) / Real(scale) : Real(1.0F / scale);
  }

  /// The ray through pixel coordinates, in view space.
  template <class Real>
  [[nodiscard]] ray_from<Real> ray(Real x, Real y) const {
    const Real zero(0.0F);
    const Real ahead(-1.0F);
    const Real right = (x - Real(0.5F * static_cast<float>(width))) / Real(scale);
    const Real up = (Real(0.5F * static_cast<float>(height)) - y) / Real(scale);
    if (perspective) return {{zero, zero, zero}, {right, up, ahead}};
    return {{right, up, zero}, {zero, zero, ahead}};
  }

  /// The same in the world.
  template <class Real>
  [[nodiscard]] ray_from<Real> world_ray(Real x, Real y) const {
    const ray_from<Real> seen = ray(x, y);
    const glm::vec<3, Real> from = filled<Real>(eye);
    return {perspective ? from : from + direction_to_world(seen.origin), direction_to_world(seen.direction)};
  }
};

/// A perspective view from `eye` toward `target`. `tan_half_fov`: of the vertical field, (0, inf).
[[nodiscard]] view perspective_view(const glm::vec3& eye, const glm::vec3& target, float tan_half_fov, int width,
                                    int height, float near_plane,
                                    pixel_footprint footprint = pixel_footprint::inscribed);

/// An orthographic view along `direction` that shows the square of side `extent` round `target`, texels × texels.
/// Its eye stands one extent before the target.
[[nodiscard]] view orthographic_view(const glm::vec3& target, const glm::vec3& direction, float extent, int texels,
                                     pixel_footprint footprint = pixel_footprint::inscribed);

}  // namespace pelage::frame
