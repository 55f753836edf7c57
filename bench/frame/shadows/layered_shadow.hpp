// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/visibility/opacity_map.hpp>

#include <utility>
#include <vector>

#include "frame/shadows/layer_layout.hpp"
#include "frame/shadows/list_shadow.hpp"

namespace pelage::frame {

/// Per texel the optical depth up to the end of each layer; within a layer it grows linearly. Opacity shadow maps and
/// deep opacity maps, by where the layers lie. 4 bytes a layer, and 4 for where they begin if texels differ.
template <std::uint32_t Layers>
class layered_shadow final : public list_shadow {
 public:
  layered_shadow(const raster& from, const solids& opaque, bool translucent, layer_layout layout)
      : list_shadow(from, opaque, translucent), layout_(std::move(layout)), width_(layout_.width(Layers)) {}

  void fill(int x, int y, std::span<pixel_fragment> all) override {
    opacity_map<Layers>& map = map_[index(x, y)];
    sum_up(index(x, y), all,
           [&](const pixel_fragment& f, std::uint32_t optical) { map.add(position(index(x, y), f.depth), optical); });
    map.accumulate();
  }

 private:
  [[nodiscard]] float position(std::size_t texel, float depth) const {
    const float offset = depth - layout_.first_of(texel);
    return layout_.widths == layer_widths::growing ? growing_layer_position(offset, width_, Layers)
                                                   : equal_layer_position(offset, width_, Layers);
  }
  [[nodiscard]] float optical_before(std::size_t texel, float depth) const override {
    return map_[texel].accumulated_before(position(texel, depth));
  }
  [[nodiscard]] std::uint64_t texel_bytes() const override {
    return map_.size() * sizeof(opacity_map<Layers>) + layout_.first.size() * sizeof(float);
  }

  layer_layout layout_;
  float width_;  ///< of the first layer
  std::vector<opacity_map<Layers>> map_ = std::vector(texels(), opacity_map<Layers>::empty());
};

}  // namespace pelage::frame
