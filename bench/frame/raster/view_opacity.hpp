// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>

#include "frame/model/strands.hpp"
#include "frame/raster/fragment_lanes.hpp"
#include "frame/raster/pixel_fragment.hpp"
#include "frame/scene/view.hpp"

namespace pelage::frame {

/// What a fibre lets pass of the light that meets it.
enum class attenuation {
  constant,  ///< 1 less the model's opacity, from all sides
  fresnel    ///< A(η, θ), by the fibre's own inclination to the ray [Yu12 §3.1]
};

/// The share of a view's rays that a fibre stops where it is met in full, [0, 1].
class view_opacity {
 public:
  /// The model's own, in every view. The strands must outlive this.
  explicit view_opacity(const strands& fibres) : fibres_(fibres) {}

  /// fibre_opacity() of the index `eta`, (0, 1e18), by the inclination of each point's tangent to the view's ray
  /// through the point; between points it is mixed. O(points), parallel.
  view_opacity(const strands& fibres, const view& from, float eta);

  [[nodiscard]] float at(std::uint32_t segment, float along) const {
    return is_same() ? *fibres_.same_opacity : fibres_.mix(per_point(), segment, along);
  }

  /// Times the fragment's coverage.
  [[nodiscard]] float alpha(const pixel_fragment& f) const { return at(f.id, f.along) * f.coverage; }
  [[nodiscard]] fragment_lanes::pack alpha(const fragment_lanes& all) const;

 private:
  [[nodiscard]] bool is_same() const { return own_.empty() && fibres_.same_opacity.has_value(); }
  [[nodiscard]] const big_array<float>& per_point() const { return own_.empty() ? fibres_.opacity : own_; }

  const strands& fibres_;
  big_array<float> own_;  ///< of each point; empty: the model's
};

// ---------------------------------------------------------------------------------------------------------

inline fragment_lanes::pack view_opacity::alpha(const fragment_lanes& all) const {
  if (is_same()) return fragment_lanes::pack(*fibres_.same_opacity) * all.coverage;
  fragment_lanes::pack opacity;
  for (int k = 0; k < fragment_lanes::width; ++k)
    opacity.lane[k] = fibres_.mix(per_point(), static_cast<std::uint32_t>(all.id[k]), all.along.lane[k]);
  return opacity * all.coverage;
}

}  // namespace pelage::frame
