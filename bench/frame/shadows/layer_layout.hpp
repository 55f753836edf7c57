// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/visibility/layer_position.hpp>

#include <cstdint>
#include <span>
#include <vector>

#include "frame/order/order_pass.hpp"

namespace pelage::frame {

/// How wide a texel's layers are: all the same, or as 1, 2, 3...
enum class layer_widths { equal, growing };

/// Where the layers of a map's texels lie.
struct layer_layout {
  std::vector<float> first;  ///< view depth at which the layers begin: of each texel, or one for all
  float extent;              ///< of all layers of a texel together, [0, inf)
  layer_widths widths = layer_widths::equal;

  /// Of the first of so many layers.
  [[nodiscard]] float width(std::uint32_t layers) const {
    return widths == layer_widths::growing ? growing_layer_width(extent, layers) : extent / static_cast<float>(layers);
  }
  [[nodiscard]] float first_of(std::size_t texel) const { return first[first.size() == 1 ? 0 : texel]; }
};

/// Layers over the whole model's depths, the same for all texels. O(points).
[[nodiscard]] layer_layout layers_of_model(const raster& from);

/// Layers that begin at each texel's nearest fragment and are as long as nine in ten texels need; what lies beyond
/// goes to the last. A pass of its own over all fragments, which `report` takes in.
[[nodiscard]] layer_layout layers_of_texels(const raster& from, std::span<const float> limit,
                                            std::span<const std::uint32_t> drawing_order, order_report& report);

}  // namespace pelage::frame
