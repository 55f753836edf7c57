// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/k_buffer_shadow.hpp"

#include <pelage/composite/optical_depth.hpp>
#include <pelage/core/lanes.hpp>

#include <algorithm>
#include <bit>

namespace pelage::frame {

k_buffer_shadow::k_buffer_shadow(const raster& from, const solids& opaque, bool translucent)
    : shadow_map(from, opaque, translucent),
      per_far_(1.0F / from.from().far_depth),
      texel_(texels(), texel{nullptr, 0, 0, 0.0F, 0.0F}) {
}

natural_of<fragment_lanes::pack> k_buffer_shadow::moment(natural_of<pack> optical, pack depth) const {
  const pack units(__builtin_convertvector(optical.lane, pack::vector));
  return to_natural(units * saturate(depth * pack(per_far_)));
}

void k_buffer_shadow::lose(int x, int y, std::span<const pixel_fragment> lost, std::span<tail> behind) {
  texel& t = texel_[index(x, y)];
  lanes<fragment_lanes::width, std::uint32_t> optical{};
  lanes<fragment_lanes::width, std::uint32_t> coverage{};
  lanes<fragment_lanes::width, std::uint32_t> moments{};
  fragment_lanes::pack farthest(t.farthest);
  for_each_lanes(lost, [&](const fragment_lanes& f) {
    const auto one = optical_depth(alpha(f));
    optical = add_saturating(optical, one);
    moments = add_saturating(moments, moment(one, f.depth));
    coverage = add_saturating(coverage, to_fixed(f.coverage));
    farthest = greatest(f.depth, farthest);
  });
  tail& sum = behind.front();
  sum.optical = add_saturating(sum.optical, sum_saturating(optical));
  sum.weight = add_saturating(sum.weight, sum_saturating(coverage));
  sum.red = add_saturating(sum.red, sum_saturating(moments));
  for (int k = 0; k < fragment_lanes::width; ++k)
    t.farthest = std::max(t.farthest, farthest.lane[k]);
}

void k_buffer_shadow::lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                                 std::span<tail> behind) {
  const auto optical = optical_depth(alpha(lost.lanes));
  const auto coverage = to_fixed(lost.lanes.coverage);
  const auto moments = moment(optical, lost.lanes.depth);
  for_each_drawn(lost, [&](std::size_t k, int x, int y, const pixel_fragment& f) {
    tail& t = behind[tail_of[k]];
    t.optical = add_saturating(t.optical, optical.lane[k]);
    t.weight = add_saturating(t.weight, coverage.lane[k]);
    t.red = add_saturating(t.red, moments.lane[k]);
    float& farthest = texel_[index(x, y)].farthest;
    farthest = std::max(farthest, f.depth);
  });
}

void k_buffer_shadow::finish(int x, int y, std::span<const pixel_fragment> nearest, std::span<const tail> behind) {
  texel& t = texel_[index(x, y)];
  const tail& rest = behind.front();
  t.behind = rest.optical;
  t.mean = rest.optical > 0 ? static_cast<float>(rest.red) / (static_cast<float>(rest.optical) * per_far_) : 0.0F;
  std::uint32_t optical = 0;
  std::uint32_t coverage = rest.weight;
  const std::span<entry> kept = nearest.empty() ? std::span<entry>() : entries_.take(nearest.size());
  t.nearest = kept.data();
  t.count = static_cast<std::uint32_t>(kept.size());
  auto out = kept.begin();
  for (const pixel_fragment& f : nearest) {
    optical = add_saturating(optical, optical_depth(alpha(f)));
    coverage = add_saturating(coverage, to_fixed(f.coverage));
    *out++ = entry{f.depth, optical};
  }
  set_sums(index(x, y), coverage, add_saturating(optical, rest.optical));
}

float k_buffer_shadow::texel::share_before(float depth) const {
  if (depth >= farthest) return 1.0F;
  const float from = count > 0 ? nearest[count - 1].depth : 0.0F;
  const float middle = std::clamp(mean, from, farthest);
  const float reach = std::min(middle - from, farthest - middle);
  return reach > 0.0F ? saturate(0.5F + 0.5F * (depth - middle) / reach) : (depth < middle ? 0.0F : 1.0F);
}

float k_buffer_shadow::optical_before(std::size_t t, float depth) const {
  const texel& here = texel_[t];
  const std::size_t count = here.count;
  const entry* const entries = here.nearest;
  std::size_t before = 0;  // entries nearer than depth, by halving without branches
  for (std::size_t step = std::bit_floor(count); step > 0; step /= 2) {
    const std::size_t next = before + step;
    const bool nearer = next <= count && entries[std::min(next, count) - 1].depth < depth;
    before = nearer ? next : before;
  }
  std::uint32_t optical = before == 0 ? 0 : entries[before - 1].optical;
  if (before == count && here.behind > 0) {
    const float behind = std::min(static_cast<float>(here.behind), 4294967040.0F);  // the last float below 2^32
    optical = add_saturating(optical, static_cast<std::uint32_t>(here.share_before(depth) * behind));
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
    for (std::size_t i = 0; i < std::min<std::size_t>(one->count, most); i += line)
      __builtin_prefetch(&one->nearest[i]);
  }
}

std::uint64_t k_buffer_shadow::texel_bytes() const {
  return texel_.size() * sizeof(texel) + entries_.bytes();
}

}  // namespace pelage::frame
