// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/occupancy_shadow.hpp"

namespace pelage::frame {

void occupancy_shadow::fill(int x, int y, std::span<pixel_fragment> all) {
  texel& t = texel_[index(x, y)];
  for (const pixel_fragment& f : all)
    t.range.extend(f.depth);
  sum_up(index(x, y), all,
         [&](const pixel_fragment& f, std::uint32_t optical) { t.map.add(t.position(f.depth), optical); });
}

float occupancy_shadow::optical_before(std::size_t t, float depth) const {
  return texel_[t].map.amount_before(texel_[t].position(depth));
}

std::uint64_t occupancy_shadow::texel_bytes() const {
  return texel_.size() * sizeof(texel);
}

}  // namespace pelage::frame
