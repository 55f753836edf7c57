// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <cstdint>

namespace pelage::frame {

/// What a segment leaves in a pixel.
struct pixel_fragment {
  std::uint32_t id;  ///< the segment's number
  float depth;       ///< view depth of the point of the pixel's ray nearest to the fibre's axis
  float coverage;    ///< share of the pixel's disc, [0, 1]; 0: the segment is not in this pixel
  float along;       ///< position on the segment, [0, 1]
};

[[nodiscard]] inline fragment fragment_of(const pixel_fragment& f) {
  return {f.depth, f.id};
}

}  // namespace pelage::frame
