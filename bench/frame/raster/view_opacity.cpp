// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster/view_opacity.hpp"

#include <pelage/bsdf/fresnel.hpp>
#include <tbb/parallel_for.h>

#include <cmath>

namespace pelage::frame {

view_opacity::view_opacity(const strands& fibres, const view& from, float eta)
    : fibres_(fibres), own_(fibres.point.size()) {
  const glm::vec3 ahead = from.direction_to_world(glm::vec3(0.0F, 0.0F, -1.0F));
  tbb::parallel_for(std::size_t{0}, own_.size(), [&](std::size_t i) {
    const glm::vec3 ray = from.perspective ? fibres.point[i] - from.eye : ahead;
    own_[i] = fibre_opacity(eta, glm::dot(fibres.tangent[i], ray) / std::sqrt(glm::dot(ray, ray)));
  });
}

}  // namespace pelage::frame
