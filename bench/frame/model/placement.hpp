// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>

#include "frame/base/wide.hpp"

namespace pelage::frame {

/// Where a copy of a model stands: turned about the y axis, from +z toward +x, then moved along the floor.
struct placement {
  glm::vec2 at{0.0F};  ///< x and z
  float cosine = 1.0F;
  float sine = 0.0F;

  // Real: float, or a pack of floats for as many points.

  template <class Real>
  [[nodiscard]] glm::vec<3, Real> turned(const glm::vec<3, Real>& d) const {
    const Real c(cosine);
    const Real s(sine);
    return {c * d.x + s * d.z, d.y, c * d.z - s * d.x};
  }

  template <class Real>
  [[nodiscard]] glm::vec<3, Real> turned_back(const glm::vec<3, Real>& d) const {
    const Real c(cosine);
    const Real s(sine);
    return {c * d.x - s * d.z, d.y, c * d.z + s * d.x};
  }

  template <class Real>
  [[nodiscard]] glm::vec<3, Real> to_world(const glm::vec<3, Real>& p) const {
    return turned(p) + filled<Real>({at.x, 0.0F, at.y});
  }

  template <class Real>
  [[nodiscard]] glm::vec<3, Real> to_model(const glm::vec<3, Real>& p) const {
    return turned_back(p - filled<Real>({at.x, 0.0F, at.y}));
  }
};

}  // namespace pelage::frame
