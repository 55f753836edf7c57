// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/k_buffer_shadow.hpp"

#include <pelage/composite/optical_depth.hpp>

#include <algorithm>

namespace pelage::frame {

k_buffer_shadow::k_buffer_shadow(const raster& from, const solids& opaque, std::uint32_t k, bool translucent)
    : shadow_map(from, opaque, translucent) {
  const std::vector<std::uint32_t> same(texels(), k);
  expect(same);
  texel_.assign(texels(), texel{0, 0, 0});
}

void k_buffer_shadow::expect(std::span<const std::uint32_t> fragments_per_pixel) {
  first_.resize(fragments_per_pixel.size());
  std::size_t total = 0;
  for (std::size_t t = 0; t < first_.size(); ++t) {
    first_[t] = total;
    total += fragments_per_pixel[t];
  }
  entry_.resize(total);
  entry_.shrink_to_fit();
}

void k_buffer_shadow::lose(int x, int y, std::span<const seen_fragment> lost, tail& behind) {
  texel& t = texel_[index(x, y)];
  for (const auto& [segment, where] : lost) {
    behind.optical = add_saturating(behind.optical, optical_depth(alpha(segment, where)));
    behind.weight = add_saturating(behind.weight, to_fixed(where.coverage));
    t.farthest = std::max(t.farthest, where.depth);
  }
}

void k_buffer_shadow::finish(int x, int y, std::span<const seen_fragment> nearest, const tail& behind) {
  texel& t = texel_[index(x, y)];
  t.count = static_cast<std::uint32_t>(nearest.size());
  t.behind = behind.optical;
  std::uint32_t optical = 0;
  std::uint32_t coverage = behind.weight;
  entry* out = entry_.data() + first_[index(x, y)];
  for (const auto& [segment, where] : nearest) {
    optical = add_saturating(optical, optical_depth(alpha(segment, where)));
    coverage = add_saturating(coverage, to_fixed(where.coverage));
    *out++ = entry{where.depth, optical};
  }
  set_sums(index(x, y), coverage, add_saturating(optical, behind.optical));
}

float k_buffer_shadow::optical_before(std::size_t t, float depth) const {
  const texel& here = texel_[t];
  const entry* begin = entry_.data() + first_[t];
  const entry* end = begin + here.count;
  const bool behind_all = here.count > 0 && end[-1].depth < depth;
  const entry* after =
      behind_all ? end : std::partition_point(begin, end, [depth](const entry& e) { return e.depth < depth; });
  std::uint32_t optical = after == begin ? 0 : after[-1].optical;
  if (after == end && here.behind > 0) {
    const float from = here.count > 0 ? end[-1].depth : 0.0F;
    const float span = here.farthest - from;
    const float share = span > 0.0F ? saturate((depth - from) / span) : 1.0F;
    const float behind = std::min(static_cast<float>(here.behind), 4294967040.0F);  // the last float below 2^32
    optical = add_saturating(optical, static_cast<std::uint32_t>(share * behind));
  }
  return static_cast<float>(optical);
}

std::uint64_t k_buffer_shadow::texel_bytes() const {
  return first_.size() * sizeof(std::size_t) + texel_.size() * sizeof(texel) + entry_.size() * sizeof(entry);
}

}  // namespace pelage::frame
