// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "frame/base/big_array.hpp"
#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// A hair model made ready to be drawn: what the passes look up by point, and the segments by number. A segment's
/// number is its fragments' id: it depends on the model alone, not on the order of drawing.
struct strands {
  big_array<glm::vec3> point;
  big_array<glm::vec3> tangent;       ///< unit, root to tip, mean of the two segments that meet
  big_array<float> radius;            ///< half the fibre's thickness
  big_array<float> opacity;           ///< of a fibre hit in full, [0, 1]
  std::optional<float> same_opacity;  ///< of all points, if the model says so
  big_array<glm::vec3> colour;        ///< linear RGB reflectance
  big_array<std::uint32_t> segment;   ///< the first of each segment's two points
  std::vector<std::uint8_t> end_of;   ///< per point, `first` and `last` where a strand begins and ends

  static constexpr std::uint8_t first = 1;
  static constexpr std::uint8_t last = 2;

  /// Position, or any other per-point value, at a place on a segment.
  template <class T>
  [[nodiscard]] T mix(const big_array<T>& value, std::uint32_t s, float along) const {
    const std::uint32_t i = segment[s];
    return value[i] + along * (value[i + 1] - value[i]);
  }

  [[nodiscard]] std::uint32_t segment_count() const { return static_cast<std::uint32_t>(segment.size()); }
};

/// What the command line may put in place of the model's own values; negative: keep those.
struct strand_overrides {
  float radius = -1.0F;
  float opacity = -1.0F;
};

/// Tangents of one strand, points [first, end). Points that lie on each other get the tangent of the one before, or +y
/// where there is none.
void set_tangents(std::span<const glm::vec3> point, std::uint32_t first, std::uint32_t end,
                  big_array<glm::vec3>& tangent);

/// O(points), parallel over strands.
[[nodiscard]] strands prepare_strands(const hair_model& model, const strand_overrides& overrides);

}  // namespace pelage::frame
