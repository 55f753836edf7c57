// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/opaque.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace pelage::truth {
namespace {

/// Where a ray enters an ellipsoid: the lesser root of |o + t d|² = 1 in the ellipsoid's own units.
std::optional<double> enter(const frame::ellipsoid& e, const ray& r) {
  const glm::dvec3 o = (r.origin - glm::dvec3(e.centre)) / glm::dvec3(e.radii);
  const glm::dvec3 d = r.direction / glm::dvec3(e.radii);
  const double a = glm::dot(d, d);
  const double half_b = glm::dot(o, d);
  const double c = glm::dot(o, o) - 1.0;
  const double discriminant = half_b * half_b - a * c;
  if (!(discriminant > 0.0) || !(c > 0.0) || !(half_b < 0.0)) return std::nullopt;
  return c / (std::sqrt(discriminant) - half_b);  // the same root, without cancellation
}

glm::dvec3 normal_of(const frame::ellipsoid& e, const glm::dvec3& p) {
  return glm::normalize((p - glm::dvec3(e.centre)) / glm::dvec3(e.radii * e.radii));
}

/// The normals of all ellipsoids whose level at p is within 0.12 of 1, weighted by the square of the nearness.
glm::dvec3 soft_normal_of(const frame::solids& opaque, const glm::dvec3& p) {
  glm::dvec3 sum(0.0);
  for (const frame::ellipsoid& e : opaque.parts) {
    const double level = glm::length((p - glm::dvec3(e.centre)) / glm::dvec3(e.radii));
    const double near = std::max(0.0, 1.0 - std::abs(level - 1.0) / 0.12);
    sum += near * near * normal_of(e, p);
  }
  return glm::normalize(sum);
}

std::optional<double> fall_on_floor(const frame::solids& opaque, const ray& r) {
  if (!opaque.floor || !(r.direction.y < 0.0)) return std::nullopt;
  const double height = static_cast<double>(*opaque.floor);
  if (!(r.origin.y > height)) return std::nullopt;
  return (height - r.origin.y) / r.direction.y;
}

}  // namespace

opaque_hit find_opaque(const frame::solids& opaque, const ray& r) {
  opaque_hit hit;
  hit.distance = r.end;
  for (std::size_t i = 0; i < opaque.parts.size(); ++i) {
    const auto entry = enter(opaque.parts[i], r);
    if (!entry || !(*entry < hit.distance)) continue;
    hit.distance = *entry;
    hit.object = static_cast<int>(i);
  }
  const auto floor = fall_on_floor(opaque, r);
  if (floor && *floor < hit.distance) {
    const double clear = static_cast<double>(opaque.clear);
    const double haze = glm::smoothstep(clear, 2.0 * clear, *floor * glm::length(r.direction));
    const glm::dvec3 up(0.0, 1.0, 0.0);
    return {*floor, up, up, glm::dvec3(opaque.ground), haze, static_cast<int>(opaque.parts.size())};
  }
  if (!hit.exists()) return {};
  const glm::dvec3 p = r.origin + hit.distance * r.direction;
  hit.normal = normal_of(opaque.parts[static_cast<std::size_t>(hit.object)], p);
  hit.soft_normal = soft_normal_of(opaque, p);
  hit.colour = glm::dvec3(opaque.skin);
  return hit;
}

bool is_blocked(const frame::solids& opaque, const ray& r) {
  for (const frame::ellipsoid& e : opaque.parts) {
    const auto entry = enter(e, r);
    if (entry && *entry < r.end) return true;
  }
  const auto floor = fall_on_floor(opaque, r);
  return floor && *floor < r.end;
}

}  // namespace pelage::truth
