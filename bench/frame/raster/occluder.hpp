// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "frame/raster/raster.hpp"

namespace pelage::frame {

/// Finds segments that opaque objects hide whole, by the farthest limit of each block of pixels. None that leaves a
/// fragment before its pixel's limit is taken for hidden; near an object's rim some that leave none are not.
class occluder {
 public:
  /// `limit`: view depth per pixel of the raster's view, at and behind which nothing is seen; empty: none.
  /// The raster must outlive this.
  occluder(const raster& from, std::span<const float> limit);

  /// `bounds`: the segment's, of the raster.
  [[nodiscard]] bool hides(std::uint32_t segment, const pixel_rect& bounds) const;

 private:
  static constexpr int side = 4;  ///< of a block, pixels

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) + static_cast<std::size_t>(x);
  }

  const raster& from_;
  int across_;                   ///< blocks in a row
  std::vector<float> farthest_;  ///< of each block's limits; empty: none
};

}  // namespace pelage::frame
