// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "../input.hpp"
#include "frame/model/hair_model.hpp"

#include <cmath>
#include <cstddef>

namespace pelage::fuzz {

/// All that hair_model promises of its members.
inline void check_model(const frame::hair_model& model) {
  const std::size_t points = model.points.size();
  law(!model.first_point.empty() && model.first_point.front() == 0 && model.first_point.back() == points,
      "strands cover the points");
  for (std::size_t s = 0; s < model.strand_count(); ++s) {
    law(model.first_point[s] <= model.first_point[s + 1], "strands do not run backwards");
  }
  law(model.segment_count() <= points, "there are fewer segments than points");
  for (const glm::vec3& p : model.points) {
    law(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "points are finite");
  }
  law(model.thickness.empty() || model.thickness.size() == points, "thickness is per point or not at all");
  law(model.transparency.empty() || model.transparency.size() == points, "transparency is per point or not at all");
  law(model.colour.empty() || model.colour.size() == points, "colour is per point or not at all");
  const auto is_thickness = [](float t) { return t >= 0.0f && std::isfinite(t); };
  const auto is_share = [](float t) { return t >= 0.0f && t <= 1.0f; };
  law(is_thickness(model.default_thickness), "the default thickness is in [0, inf)");
  law(is_share(model.default_transparency), "the default transparency is in [0, 1]");
  for (const float t : model.thickness) {
    law(is_thickness(t), "thickness is in [0, inf)");
  }
  for (const float t : model.transparency) {
    law(is_share(t), "transparency is in [0, 1]");
  }
  for (const glm::vec3& c : model.colour) {
    law(is_thickness(c.x) && is_thickness(c.y) && is_thickness(c.z), "colour is in [0, inf)");
  }
}

}  // namespace pelage::fuzz
