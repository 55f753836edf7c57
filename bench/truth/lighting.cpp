// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/lighting.hpp"

#include <algorithm>
#include <cmath>

namespace pelage::truth {
namespace {

// The look that bench/frame/shading gives fibres and the room.
constexpr double diffuse_weight = 0.55;
constexpr double specular_weight = 0.22;
constexpr double exponent = 60.0;
constexpr double sky_share = 0.30;
constexpr glm::dvec3 low_background{0.62, 0.63, 0.66};
constexpr glm::dvec3 high_background{1.05, 1.08, 1.14};

}  // namespace

lighting::arrival lighting::arriving(const frame::light& from, const glm::dvec3& at) const {
  const glm::dvec3 colour(from.colour);
  if (from.kind == frame::light_kind::directional) {
    const glm::dvec3 to_light = -glm::dvec3(from.direction);
    return {{at, to_light}, to_light, colour};
  }
  const glm::dvec3 way = glm::dvec3(from.position) - at;
  const double distance = glm::length(way);
  const glm::dvec3 to_light = way / distance;
  const double at_centre = glm::distance(glm::dvec3(from.position), glm::dvec3(set_.round.centre));
  double strength = at_centre * at_centre / (distance * distance);
  if (from.kind == frame::light_kind::spot) {
    const double inside = -glm::dot(to_light, glm::dvec3(from.direction));
    strength *= glm::smoothstep(static_cast<double>(from.cos_outer), static_cast<double>(from.cos_inner), inside);
  }
  return {{at, to_light, distance}, to_light, strength * colour};
}

glm::dvec3 lighting::place_of(const fibre_hit& h) const {
  const frame::strands& f = set_.fibres;
  const std::uint32_t i = f.segment[h.segment];
  return glm::mix(glm::dvec3(f.point[i]), glm::dvec3(f.point[i + 1]), static_cast<double>(h.along));
}

glm::dvec3 lighting::place_of(const opaque_hit& h, const ray& seen) const {
  return seen.origin + h.distance * seen.direction + 1e-6 * static_cast<double>(set_.round.radius) * h.normal;
}

double lighting::passing(const ray& way, std::uint32_t own) const {
  return is_blocked(set_.opaque, way) ? 0.0 : fibres_.transmittance(way, own);
}

lighting::fibre_surface lighting::surface_of(const fibre_hit& h, const ray& seen) const {
  const frame::strands& f = set_.fibres;
  const std::uint32_t i = f.segment[h.segment];
  const auto share = static_cast<double>(h.along);
  const auto between = [&](const auto& value) {
    return glm::mix(glm::dvec3(value[i]), glm::dvec3(value[i + 1]), share);
  };
  return {glm::normalize(between(f.tangent)), -glm::normalize(seen.direction), between(f.colour)};
}

/// [Kajiya & Kay 1989, Eqs. 14 and 16]
glm::dvec3 lighting::scattered(const fibre_surface& s, const arrival& in) {
  const double cos_light = glm::dot(s.tangent, in.to_light);
  const double cos_eye = glm::dot(s.tangent, s.to_eye);
  const double sin_light = std::sqrt(std::max(0.0, 1.0 - cos_light * cos_light));
  const double sin_eye = std::sqrt(std::max(0.0, 1.0 - cos_eye * cos_eye));
  const double mirror = std::max(0.0, sin_light * sin_eye - cos_light * cos_eye);
  return in.colour * (diffuse_weight * sin_light * s.colour + specular_weight * std::pow(mirror, exponent));
}

glm::dvec3 lighting::sky_on(const fibre_surface& s) const {
  return sky_share * glm::dvec3(set_.sky) * s.colour;
}

glm::dvec3 lighting::sky_on(const opaque_hit& h) const {
  return 0.5 * (1.0 + 0.3 * h.soft_normal.y) * glm::dvec3(set_.sky) * h.colour;
}

glm::dvec3 lighting::background(const glm::dvec3& direction) const {
  const double up = 0.5 + 0.5 * glm::normalize(direction).y;
  return glm::dvec3(set_.sky) * glm::mix(low_background, high_background, up);
}

}  // namespace pelage::truth
