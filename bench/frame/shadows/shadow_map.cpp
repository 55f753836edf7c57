// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/shadow_map.hpp"

#include <pelage/core/math.hpp>

#include <limits>

namespace pelage::frame {
namespace {

constexpr float unit = 1.0F / 1048576.0F;  ///< of fixed-point sums, octaves or fibres

}  // namespace

shadow_map::shadow_map(const raster& from, const solids& opaque, bool translucent)
    : fibres_(from.fibres()),
      light_(from.from()),
      translucent_(translucent),
      limit_(opaque_depths(from.from(), opaque)),
      fibres_per_octave_(limit_.size(), 0.0F) {
}

shadow_map::spots shadow_map::find(const wide3& world, wide bias, std::uint32_t set) const {
  const wide zero(0.0F);
  const wide3 p = light_.to_view(world);
  const wide depth = zero - p.z - bias;
  const glm::vec<2, wide> pixel = light_.to_pixel(p);
  const wide width(static_cast<float>(light_.width));
  const wide height(static_cast<float>(light_.height));
  // The borders belong to the map. A NaN is nowhere.
  const auto within = [&](wide at, wide size) {
    return (bits(at > zero) | bits(at < size)) & ~(bits(at < zero) | bits(at > size));
  };
  const std::uint32_t inside =
      set & within(pixel.x, width) & within(pixel.y, height) & bits(depth > wide(light_.near_plane));

  // The rim has its texel's value.
  const auto between = [&](wide at, wide size) { return least(greatest(at - wide(0.5F), zero), size - wide(1.0F)); };
  const wide across = between(pixel.x, width);
  const wide down = between(pixel.y, height);
  const wide left = least(whole_part(across), width - wide(2.0F));
  const wide above = least(whole_part(down), height - wide(2.0F));
  spots found{{}, inside, across - left, down - above, depth};
  for_each_lane(inside, [&](int k) {
    found.first[static_cast<std::size_t>(k)] =
        static_cast<std::uint32_t>(index(static_cast<int>(left.lane[k]), static_cast<int>(above.lane[k])));
  });
  return found;
}

void shadow_map::prefetch(const spots& at, int step) const {
  for_each_lane(at.inside, [&](int k) {
    const std::size_t first = at.first[static_cast<std::size_t>(k)];
    for (const std::size_t left : {first, first + static_cast<std::size_t>(light_.width)}) {
      if (step == 0) {
        __builtin_prefetch(&limit_[left]);
        __builtin_prefetch(&fibres_per_octave_[left]);
      }
      prefetch_texels(left, step);
    }
  });
}

wide3 shadow_map::passed_in(const spots& at, std::size_t offset) const {
  alignas(sizeof(wide)) float octaves[wide_width] = {};
  alignas(sizeof(wide)) float per_octave[wide_width] = {};
  alignas(sizeof(wide)) float open[wide_width] = {};
  for_each_lane(at.inside, [&](int k) {
    const std::size_t texel = at.first[static_cast<std::size_t>(k)] + offset;
    const bool hidden = at.depth.lane[k] > limit_[texel];
    octaves[k] = optical_before(texel, hidden ? std::numeric_limits<float>::infinity() : at.depth.lane[k]);
    per_octave[k] = fibres_per_octave_[texel];
    open[k] = hidden ? 0.0F : 1.0F;
  });
  const wide sum = wide::load(octaves) * wide(unit);
  const wide left = wide::load(open);
  return {select(left > wide(0.0F), fast_exp2(wide(0.0F) - sum), wide(0.0F)), sum * wide::load(per_octave), left};
}

passage_of<wide> shadow_map::passed_to(const spots& at) const {
  const auto below = static_cast<std::size_t>(light_.width);
  const auto mix = [](const wide3& a, const wide3& b, wide share) { return a * (wide(1.0F) - share) + b * share; };
  const wide3 top = mix(passed_in(at, 0), passed_in(at, 1), at.across);
  const wide3 bottom = mix(passed_in(at, below), passed_in(at, below + 1), at.across);
  const wide3 mean = mix(top, bottom, at.down);
  const auto inside = mask_of(at.inside);
  return {select(inside, mean.x, wide(1.0F)), select(inside, mean.y, wide(0.0F)), select(inside, mean.z, wide(1.0F))};
}

passage shadow_map::passed_to(const glm::vec3& world, float bias) const {
  const passage_of<wide> passed = passed_to(find(filled<wide>(world), wide(bias), 1U));
  return {passed.transmittance.lane[0], passed.fibres.lane[0], passed.open.lane[0]};
}

float shadow_map::transmittance_to(const glm::vec3& world, float bias) const {
  return passed_to(world, bias).transmittance;
}

std::uint64_t shadow_map::bytes() const {
  return texel_bytes() + (limit_.size() + fibres_per_octave_.size()) * sizeof(float);
}

float shadow_map::alpha(const pixel_fragment& f) const {
  if (!translucent_) return f.coverage;
  const float opacity = fibres_.same_opacity ? *fibres_.same_opacity : fibres_.mix(fibres_.opacity, f.id, f.along);
  return opacity * f.coverage;
}

fragment_lanes::pack shadow_map::alpha(const fragment_lanes& all) const {
  return translucent_ ? alpha_of(fibres_, all) : all.coverage;
}

void shadow_map::set_sums(std::size_t texel, std::uint32_t coverage, std::uint32_t optical) {
  fibres_per_octave_[texel] = optical > 0 ? static_cast<float>(coverage) / static_cast<float>(optical) : 0.0F;
}

}  // namespace pelage::frame
