// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/occupancy_map.hpp>

#include <vector>

#include "frame/shadows/list_shadow.hpp"

namespace pelage::frame {

/// Per texel an occupancy map over its own depth range: which of 128 slices hold anything, and the optical depth of
/// each of 4 slabs. Exact at the ends of slabs. 40 bytes a texel.
class occupancy_shadow final : public list_shadow {
 public:
  using list_shadow::list_shadow;

  void fill(int x, int y, std::span<pixel_fragment> all) override;

 private:
  struct texel {
    depth_range range = depth_range::empty();
    occupancy_map<> map = occupancy_map<>::empty();

    [[nodiscard]] float position(float depth) const { return slice_position(range.relative(depth), 128U); }
  };

  [[nodiscard]] float optical_before(std::size_t texel, float depth) const override;
  [[nodiscard]] std::uint64_t texel_bytes() const override;

  std::vector<texel> texel_ = std::vector<texel>(texels());
};

}  // namespace pelage::frame
