// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/k_buffer_shadow.hpp"

#include <pelage/composite/optical_depth.hpp>
#include <pelage/core/lanes.hpp>

#include <algorithm>
#include <bit>

namespace pelage::frame {

k_buffer_shadow::k_buffer_shadow(const raster& from, const solids& opaque, bool translucent)
    : shadow_map(from, opaque, translucent), texel_(texels(), texel{{}, 0, 0.0F}) {
}

void k_buffer_shadow::lose(int x, int y, std::span<const pixel_fragment> lost, std::span<tail> behind) {
  texel& t = texel_[index(x, y)];
  lanes<fragment_lanes::width, std::uint32_t> optical{};
  lanes<fragment_lanes::width, std::uint32_t> coverage{};
  fragment_lanes::pack farthest(t.farthest);
  for_each_lanes(lost, [&](const fragment_lanes& f) {
    optical = add_saturating(optical, optical_depth(alpha(f)));
    coverage = add_saturating(coverage, to_fixed(f.coverage));
    farthest = greatest(f.depth, farthest);
  });
  tail& sum = behind.front();
  sum.optical = add_saturating(sum.optical, sum_saturating(optical));
  sum.weight = add_saturating(sum.weight, sum_saturating(coverage));
  for (int k = 0; k < fragment_lanes::width; ++k)
    t.farthest = std::max(t.farthest, farthest.lane[k]);
}

void k_buffer_shadow::lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                                 std::span<tail> behind) {
  const auto optical = optical_depth(alpha(lost.lanes));
  const auto coverage = to_fixed(lost.lanes.coverage);
  for_each_drawn(lost, [&](std::size_t k, int x, int y, const pixel_fragment& f) {
    tail& t = behind[tail_of[k]];
    t.optical = add_saturating(t.optical, optical.lane[k]);
    t.weight = add_saturating(t.weight, coverage.lane[k]);
    float& farthest = texel_[index(x, y)].farthest;
    farthest = std::max(farthest, f.depth);
  });
}

void k_buffer_shadow::finish(int x, int y, std::span<const pixel_fragment> nearest, std::span<const tail> behind) {
  texel& t = texel_[index(x, y)];
  t.behind = behind.front().optical;
  std::uint32_t optical = 0;
  std::uint32_t coverage = behind.front().weight;
  const std::span<entry> kept = nearest.empty() ? std::span<entry>() : entries_.take(nearest.size());
  t.nearest = kept;
  auto out = kept.begin();
  for (const pixel_fragment& f : nearest) {
    optical = add_saturating(optical, optical_depth(alpha(f)));
    coverage = add_saturating(coverage, to_fixed(f.coverage));
    *out++ = entry{f.depth, optical};
  }
  set_sums(index(x, y), coverage, add_saturating(optical, t.behind));
}

float k_buffer_shadow::optical_before(std::size_t t, float depth) const {
  const texel& here = texel_[t];
  const std::size_t count = here.nearest.size();
  const entry* const entries = here.nearest.data();
  std::size_t before = 0;  // entries nearer than depth, by halving without branches
  for (std::size_t step = std::bit_floor(count); step > 0; step /= 2) {
    const std::size_t next = before + step;
    const bool nearer = next <= count && entries[std::min(next, count) - 1].depth < depth;
    before = nearer ? next : before;
  }
  std::uint32_t optical = before == 0 ? 0 : entries[before - 1].optical;
  if (before == count && here.behind > 0) {
    const float from = count > 0 ? entries[count - 1].depth : 0.0F;
    const float span = here.farthest - from;
    const float share = span > 0.0F ? saturate((depth - from) / span) : 1.0F;
    const float behind = std::min(static_cast<float>(here.behind), 4294967040.0F);  // the last float below 2^32
    optical = add_saturating(optical, static_cast<std::uint32_t>(share * behind));
  }
  return static_cast<float>(optical);
}

void k_buffer_shadow::prefetch_texels(std::size_t t, int step) const {
  constexpr std::size_t line = 64 / sizeof(entry);
  constexpr std::size_t most = 4 * line;
  for (const texel* one : {&texel_[t], &texel_[t + 1]}) {
    if (step == 0) {
      __builtin_prefetch(one);
      continue;
    }
    const std::span<const entry> kept = one->nearest;
    for (std::size_t i = 0; i < std::min(kept.size(), most); i += line)
      __builtin_prefetch(&kept[i]);
  }
}

std::uint64_t k_buffer_shadow::texel_bytes() const {
  return texel_.size() * sizeof(texel) + entries_.bytes();
}

}  // namespace pelage::frame
