// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/solids.hpp"

#include <algorithm>
#include <cmath>

namespace pelage::frame {

body_sphere body_sphere::round(std::span<const ellipsoid> parts) {
  if (parts.empty()) return {};
  box all;
  for (const ellipsoid& part : parts) {
    all.lower = glm::min(all.lower, part.centre - part.radii);
    all.upper = glm::max(all.upper, part.centre + part.radii);
  }
  body_sphere found{0.5F * (all.lower + all.upper), 0.0F};
  for (const ellipsoid& part : parts) {
    const float greatest = std::max({part.radii.x, part.radii.y, part.radii.z});
    found.radius = std::max(found.radius, glm::length(part.centre - found.centre) + 1.15F * greatest);
  }
  return found;
}

body_sphere body_sphere::round(std::span<const body_sphere> bodies) {
  body_sphere found;
  for (const body_sphere& body : bodies)
    found.centre += body.centre / static_cast<float>(bodies.size());
  for (const body_sphere& body : bodies)
    found.radius = std::max(found.radius, 1.0001F * (glm::length(body.centre - found.centre) + body.radius));
  return found;
}

void solids::set_copies(std::span<const placement> places) {
  const body_sphere one = body_sphere::round(parts);
  copies.assign(places.begin(), places.end());
  bodies.clear();
  clusters.clear();
  for (const placement& place : copies)
    bodies.push_back({place.to_world(one.centre), one.radius});
  for (std::size_t first = 0; first < bodies.size(); first += cluster_size) {
    const std::size_t count = std::min(cluster_size, bodies.size() - first);
    clusters.push_back(body_sphere::round(std::span<const body_sphere>(bodies).subspan(first, count)));
  }
}

std::optional<ellipsoid> fit_head(const hair_model& model) {
  const box bounds = model.bounds();
  if (bounds.empty()) return std::nullopt;
  const glm::dvec3 middle = 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
  const double size = glm::length(glm::dvec3(bounds.upper - bounds.lower));

  // |x|² = 2 c·x + (r² - |c|²) is linear in c and in the bracket: normal equations in units of the model's size.
  glm::dmat4 normal(0.0);
  glm::dvec4 right(0.0);
  double roots = 0;
  for (std::size_t s = 0; s < model.strand_count(); ++s) {
    if (model.point_count(s) == 0) continue;
    const glm::dvec3 x = (glm::dvec3(model.points[model.first_point[s]]) - middle) / size;
    const glm::dvec4 row(2.0 * x, 1.0);
    normal += glm::outerProduct(row, row);
    right += row * glm::dot(x, x);
    roots += 1;
  }
  const double determinant = glm::determinant(normal / std::max(roots, 1.0));
  if (!(determinant > 1e-12)) return std::nullopt;
  const glm::dvec4 solved = glm::inverse(normal) * right;
  const glm::dvec3 centre(solved);
  const double radius = std::sqrt(solved.w + glm::dot(centre, centre));

  double error2 = 0;
  for (std::size_t s = 0; s < model.strand_count(); ++s) {
    if (model.point_count(s) == 0) continue;
    const glm::dvec3 x = (glm::dvec3(model.points[model.first_point[s]]) - middle) / size;
    const double error = glm::length(x - centre) - radius;
    error2 += error * error;
  }
  const double spread = std::sqrt(error2 / roots);
  if (!(radius < 1.0) || !(spread < 0.1 * radius)) return std::nullopt;
  const double shrunk = radius - spread;
  return ellipsoid{glm::vec3(middle + size * centre), glm::vec3(static_cast<float>(size * shrunk))};
}

}  // namespace pelage::frame
