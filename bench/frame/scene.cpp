// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene.hpp"

#include <algorithm>

namespace pelage::frame {
namespace {

constexpr float sky_share = 0.30F;  ///< of the sky's light, what reaches every fibre through the others

}  // namespace

glm::vec3 scene::fibre_radiance(std::uint32_t segment, float along, const glm::vec3& to_eye) const {
  const auto at = [&](const auto& value) { return fibres.mix(value, segment, along); };
  const glm::vec3 position = at(fibres.point);
  const fibre_place place{glm::normalize(at(fibres.tangent)), to_eye, at(fibres.colour), at(fibres.opacity)};
  glm::vec3 sum = sky_share * sky * bsdf.reflect_sky(place);
  for (const lit& l : lights) {
    const arrival in = light_at(l.source, bounds, position);
    const passage passed = l.shadow
                               ? l.shadow->passed_to(position, 2.0F * at(fibres.radius) + l.shadow->texel_at(position))
                               : passage{1.0F, 0.0F, 1.0F};
    sum += in.colour * bsdf.scatter(place, in.to_light, passed);
  }
  return sum;
}

glm::vec3 scene::solid_radiance(const glm::vec3& position, const solid_hit& hit) const {
  glm::vec3 sum = 0.5F * (1.0F + 0.3F * hit.normal.y) * sky;
  for (const lit& l : lights) {
    const arrival in = light_at(l.source, bounds, position);
    const float facing = glm::dot(hit.normal, in.to_light);
    if (facing <= 0.0F) continue;
    const float texel = l.shadow ? l.shadow->texel_at(position) : 0.0F;
    const glm::vec3 lifted = position + 2.0F * texel * hit.normal;
    const float passed = l.shadow ? l.shadow->transmittance_to(lifted, texel / std::max(facing, 0.2F)) : 1.0F;
    sum += passed * facing * in.colour;
  }
  return hit.colour * sum;
}

glm::vec3 scene::background(const glm::vec3& direction) const {
  const float up = 0.5F + 0.5F * glm::normalize(direction).y;
  return sky * glm::mix(glm::vec3(0.62F, 0.63F, 0.66F), glm::vec3(1.05F, 1.08F, 1.14F), up);
}

}  // namespace pelage::frame
