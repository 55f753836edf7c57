// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/camera_film.hpp"

#include <pelage/composite/radiance.hpp>
#include <pelage/composite/tail_lanes.hpp>

#include <bit>

#include "frame/order/seen_lanes.hpp"

namespace pelage::frame {

camera_film::camera_film(const raster& from, const backdrop& behind, const shaded_fibres& shades, components shown)
    : from_(from), behind_(behind), shades_(shades), shown_(shown), picture_(behind.picture()) {
}

std::size_t camera_film::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
}

float camera_film::visible_coverage(std::size_t pixel, const touch& where) const {
  return where.coverage * behind_.share_behind(pixel, where.depth);
}

float camera_film::opacity(const seen_fragment& f) const {
  return has_translucency(shown_) ? from_.mix(from_.fibres().opacity, f.id, f.where.along) : 1.0F;
}

void camera_film::lose(int x, int y, std::span<const seen_fragment> lost, tail& behind) {
  const std::size_t pixel = index(x, y);
  for (const seen_fragment& f : lost)
    behind = add_fragment(behind, opacity(f) * visible_coverage(pixel, f.where), shades_.at(f.id, f.where.along));
}

void camera_film::lose_lanes(const raster::touches& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                             std::span<tail> behind) {
  seen_lanes::pack share(1.0F);
  for_each_touch(lost, [&](std::size_t k, std::uint32_t, int x, int y, const touch& where) {
    share.lane[k] = behind_.share_behind(index(x, y), where.depth);
  });
  const auto any = seen_lanes::integers{} + lost.segment[std::countr_zero(lost.set)];
  const seen_lanes f{lost.is_set() ? lost.segment : any, lost.depth, lost.coverage * share, lost.along};
  const seen_lanes::pack alpha = has_translucency(shown_) ? alpha_of(from_.fibres(), f) : f.coverage;
  add_fragments(alpha, shades_.at(f), lost.set, tail_of, behind);
}

void camera_film::finish(int x, int y, std::span<const seen_fragment> nearest, const tail& behind) {
  pixel_radiance<float> pixel = empty_pixel<float>();
  for (const seen_fragment& f : nearest) {
    pixel = add_fibre(pixel, shades_.at(f.id, f.where.along), glm::vec3(1.0F - opacity(f)),
                      visible_coverage(index(x, y), f.where));
  }
  pixel = add_fibre(pixel, mean_colour(behind), glm::vec3(transmittance_of(behind)), 1.0F);
  picture_.at(x, y) = resolve(pixel, behind_fibres(x, y));
}

void camera_film::look_at(int x, int y, std::span<const seen_fragment> all, std::vector<layer>& layers) const {
  layers.clear();
  for (const seen_fragment& f : all) {
    layers.push_back(
        {fragment_of(f), opacity(f) * visible_coverage(index(x, y), f.where), shades_.at(f.id, f.where.along)});
  }
}

}  // namespace pelage::frame
