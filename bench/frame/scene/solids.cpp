// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/solids.hpp"

#include <cmath>

namespace pelage::frame {

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
