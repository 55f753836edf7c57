// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/shadow_map.hpp"

#include <pelage/core/math.hpp>
#include <pelage/visibility/lookup_jitter.hpp>
#include <pelage/visibility/receiver.hpp>

#include <limits>

namespace pelage::frame {
namespace {

constexpr float unit = 1.0F / 1048576.0F;  ///< of fixed-point sums, octaves or fibres

constexpr float steepest = 64.0F;  ///< of receivers: up to there pixel coordinates give depths within 0.02 texels

}  // namespace

shadow_map::shadow_map(const raster& from, const solids& opaque, bool translucent)
    : opacity_(from.opacity()),
      light_(from.from()),
      translucent_(translucent),
      limit_(opaque_depths(from.from(), opaque)),
      fibres_per_octave_(limit_.size(), 0.0F) {
}

wide3 shadow_map::ray_to(const wide3& seen) const {
  const wide zero(0.0F);
  const wide ahead(-1.0F);
  if (!light_.perspective) return {zero, zero, ahead};
  const wide depth = greatest(zero - seen.z, wide(light_.near_plane));
  return {seen.x / depth, seen.y / depth, ahead};
}

shadow_map::spots shadow_map::find_on_fibres(const wide3& world, const wide3& tangent, wide bias,
                                             std::uint32_t set) const {
  const wide3 seen = light_.to_view(world);
  return find(seen, slope_on_fibre(seen, tangent), bias, set, false);
}

shadow_map::spots shadow_map::find_jittered_on_fibres(const wide3& world, const wide3& tangent, wide bias,
                                                      const std::array<std::uint32_t, wide_width>& seed,
                                                      std::uint32_t set) const {
  const wide zero(0.0F);
  const wide one(1.0F);
  const wide3 seen = light_.to_view(world);
  const wide depth = zero - seen.z - bias;
  const wide2 pixel = light_.to_pixel(seen);
  const std::uint32_t found = set & inside(pixel, depth);
  wide2 offset{zero, zero};
  for_each_lane(found, [&](int k) {
    const glm::vec2 jitter = lookup_jitter(seed[static_cast<std::size_t>(k)]);
    offset.x.lane[k] = jitter.x;
    offset.y.lane[k] = jitter.y;
  });
  const auto texel_at = [&](wide at, int size) {
    return least(whole_part(greatest(at, zero)), wide(static_cast<float>(size)) - one);
  };
  const wide column = texel_at(pixel.x + offset.x, light_.width);
  const wide row = texel_at(pixel.y + offset.y, light_.height);
  const wide half(0.5F);
  const wide2 slope = slope_on_fibre(seen, tangent);
  const wide width = light_.pixel_at(seen);
  const wide there = depth + ((column + half - pixel.x) * slope.x - (row + half - pixel.y) * slope.y) * width;
  spots all{{}, found, zero, zero, there, zero, zero, false, true};
  for_each_lane(found, [&](int k) {
    all.first[static_cast<std::size_t>(k)] =
        static_cast<std::uint32_t>(index(static_cast<int>(column.lane[k]), static_cast<int>(row.lane[k])));
  });
  return all;
}

wide2 shadow_map::slope_on_fibre(const wide3& seen, const wide3& tangent) const {
  return line_depth_slope(ray_to(seen), light_.direction_to_view(tangent), wide(steepest));
}

std::uint32_t shadow_map::inside(const wide2& pixel, wide depth) const {
  const wide zero(0.0F);
  const auto within = [&](wide at, int side) {
    const wide size(static_cast<float>(side));
    return (bits(at > zero) | bits(at < size)) & ~(bits(at < zero) | bits(at > size));
  };
  return within(pixel.x, light_.width) & within(pixel.y, light_.height) & bits(depth > wide(light_.near_plane));
}

shadow_map::spots shadow_map::find_on_surfaces(const wide3& world, const wide3& normal, std::uint32_t set) const {
  const wide3 seen = light_.to_view(world);
  const wide2 slope = plane_depth_slope(ray_to(seen), light_.direction_to_view(normal), wide(steepest));
  return find(seen, slope, wide(0.0F), set, true);
}

shadow_map::spots shadow_map::find(const wide3& seen, const wide2& slope, wide bias, std::uint32_t set,
                                   bool among_fibres) const {
  const wide zero(0.0F);
  const wide depth = zero - seen.z - bias;
  const wide2 pixel = light_.to_pixel(seen);
  const wide width(static_cast<float>(light_.width));
  const wide height(static_cast<float>(light_.height));
  const std::uint32_t found_inside = set & inside(pixel, depth);

  // The rim has its texel's value.
  const auto between = [&](wide at, wide size) { return least(greatest(at - wide(0.5F), zero), size - wide(1.0F)); };
  const wide across = between(pixel.x, width);
  const wide down = between(pixel.y, height);
  const wide left = least(whole_part(across), width - wide(2.0F));
  const wide above = least(whole_part(down), height - wide(2.0F));
  const wide half(0.5F);
  const wide growth_across = slope.x * light_.pixel_at(seen);
  const wide growth_down = zero - slope.y * light_.pixel_at(seen);
  const wide there = depth + (left + half - pixel.x) * growth_across + (above + half - pixel.y) * growth_down;
  spots found{{}, found_inside, across - left, down - above, there, growth_across, growth_down, among_fibres, false};
  for_each_lane(found_inside, [&](int k) {
    found.first[static_cast<std::size_t>(k)] =
        static_cast<std::uint32_t>(index(static_cast<int>(left.lane[k]), static_cast<int>(above.lane[k])));
  });
  return found;
}

void shadow_map::prefetch(const spots& at, int step) const {
  for_each_lane(at.inside, [&](int k) {
    const std::size_t first = at.first[static_cast<std::size_t>(k)];
    const std::size_t last = at.is_one_texel ? first : first + static_cast<std::size_t>(light_.width);
    for (std::size_t left = first; left <= last; left += static_cast<std::size_t>(light_.width)) {
      if (step == 0) {
        __builtin_prefetch(&limit_[left]);
        __builtin_prefetch(&fibres_per_octave_[left]);
      }
      prefetch_texels(left, step);
    }
  });
}

wide3 shadow_map::passed_in(const spots& at, std::size_t offset, wide depth) const {
  alignas(sizeof(wide)) float octaves[wide_width] = {};
  alignas(sizeof(wide)) float per_octave[wide_width] = {};
  alignas(sizeof(wide)) float open[wide_width] = {};
  for_each_lane(at.inside, [&](int k) {
    const std::size_t texel = at.first[static_cast<std::size_t>(k)] + offset;
    const bool hidden = depth.lane[k] > limit_[texel];
    octaves[k] = optical_before(texel, hidden ? std::numeric_limits<float>::infinity() : depth.lane[k]);
    per_octave[k] = fibres_per_octave_[texel];
    open[k] = hidden && !at.among_fibres ? 0.0F : 1.0F;
  });
  const wide sum = wide::load(octaves) * wide(unit);
  const wide left = wide::load(open);
  return {select(left > wide(0.0F), fast_exp2(wide(0.0F) - sum), wide(0.0F)), sum * wide::load(per_octave), left};
}

passage_of<wide> shadow_map::passed_to(const spots& at) const {
  const auto below = static_cast<std::size_t>(light_.width);
  const auto mix = [](const wide3& a, const wide3& b, wide share) { return a * (wide(1.0F) - share) + b * share; };
  const auto done = [inside = mask_of(at.inside)](const wide3& passed) {
    return passage_of<wide>{select(inside, passed.x, wide(1.0F)), select(inside, passed.y, wide(0.0F)),
                            select(inside, passed.z, wide(1.0F))};
  };
  if (at.is_one_texel) return done(passed_in(at, 0, at.depth));
  const wide lower = at.depth + at.growth_down;
  const wide3 top = mix(passed_in(at, 0, at.depth), passed_in(at, 1, at.depth + at.growth_across), at.across);
  const wide3 bottom = mix(passed_in(at, below, lower), passed_in(at, below + 1, lower + at.growth_across), at.across);
  return done(mix(top, bottom, at.down));
}

passage shadow_map::passed_to(const glm::vec3& world, float bias) const {
  const passage_of<wide> passed =
      passed_to(find(light_.to_view(filled<wide>(world)), wide2(wide(0.0F)), wide(bias), 1U, false));
  return {passed.transmittance.lane[0], passed.fibres.lane[0], passed.open.lane[0]};
}

float shadow_map::transmittance_to(const glm::vec3& world, float bias) const {
  return passed_to(world, bias).transmittance;
}

std::uint64_t shadow_map::bytes() const {
  return texel_bytes() + (limit_.size() + fibres_per_octave_.size()) * sizeof(float);
}

float shadow_map::alpha(const pixel_fragment& f) const {
  return translucent_ ? opacity_.alpha(f) : f.coverage;
}

fragment_lanes::pack shadow_map::alpha(const fragment_lanes& all) const {
  return translucent_ ? opacity_.alpha(all) : all.coverage;
}

void shadow_map::set_sums(std::size_t texel, std::uint32_t coverage, std::uint32_t optical) {
  fibres_per_octave_[texel] = optical > 0 ? static_cast<float>(coverage) / static_cast<float>(optical) : 0.0F;
}

}  // namespace pelage::frame
