// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelage::frame {

/// An axis-aligned box. Empty (lower > upper) when it holds no point.
struct box {
  glm::vec3 lower{+std::numeric_limits<float>::infinity()};
  glm::vec3 upper{-std::numeric_limits<float>::infinity()};

  [[nodiscard]] bool empty() const { return lower.x > upper.x; }
};

/// Fibres as polylines: strand s is points[first_point[s]] … points[first_point[s + 1] - 1], root to tip.
///
/// A strand of 0 or 1 points is legal and has no segments. The per-point arrays are either empty, and then
/// the default holds for every point, or as long as `points`. Lengths are in the model's own units.
struct hair_model {
  std::vector<glm::vec3> points;              ///< finite
  std::vector<std::uint32_t> first_point{0};  ///< strand_count() + 1 entries, never falling, from 0 to points.size()

  std::vector<float> thickness;     ///< a fibre's diameter at a point, [0, +inf)
  std::vector<float> transparency;  ///< 0 is opaque, 1 invisible, [0, 1]
  std::vector<glm::vec3> colour;    ///< linear RGB reflectance, each channel [0, +inf)

  float default_thickness = 0.001F;
  float default_transparency = 0.5F;
  glm::vec3 default_colour{0.27F, 0.15F, 0.07F};

  [[nodiscard]] std::size_t strand_count() const { return first_point.size() - 1; }

  /// Points of strand s, s in [0, strand_count()).
  [[nodiscard]] std::uint32_t point_count(std::size_t s) const { return first_point[s + 1] - first_point[s]; }

  /// Pairs of neighbouring points over all strands. O(strands).
  [[nodiscard]] std::size_t segment_count() const;

  /// The box of all points, fibre width not counted. O(points).
  [[nodiscard]] box bounds() const;
};

inline std::size_t hair_model::segment_count() const {
  std::size_t count = 0;
  for (std::size_t s = 0; s < strand_count(); ++s) {
    const std::uint32_t n = point_count(s);
    count += n > 1 ? n - 1 : 0;
  }
  return count;
}

inline box hair_model::bounds() const {
  box b;
  for (const glm::vec3& p : points) {
    b.lower = glm::min(b.lower, p);
    b.upper = glm::max(b.upper, p);
  }
  return b;
}

}  // namespace pelage::frame
