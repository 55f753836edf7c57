// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/camera_film.hpp"

#include <pelage/composite/radiance.hpp>
#include <pelage/composite/tail_lanes.hpp>

#include <bit>

#include "frame/raster/fragment_lanes.hpp"

namespace pelage::frame {

camera_film::camera_film(const raster& from, const backdrop& behind, const shaded_fibres& shades, components shown)
    : from_(from), behind_(behind), shades_(shades), shown_(shown), picture_(behind.picture()) {
}

std::size_t camera_film::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
}

float camera_film::visible_coverage(std::size_t pixel, const pixel_fragment& f) const {
  return f.coverage * behind_.share_behind(pixel, f.depth);
}

float camera_film::opacity(const pixel_fragment& f) const {
  return has_translucency(shown_) ? from_.mix(from_.fibres().opacity, f.id, f.along) : 1.0F;
}

void camera_film::lose(int x, int y, std::span<const pixel_fragment> lost, tail& behind) {
  const std::size_t pixel = index(x, y);
  for (const pixel_fragment& f : lost)
    behind = add_fragment(behind, opacity(f) * visible_coverage(pixel, f), shades_.at(f.id, f.along));
}

void camera_film::lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                             std::span<tail> behind) {
  fragment_lanes::pack share(1.0F);
  for_each_drawn(lost, [&](std::size_t k, int x, int y, const pixel_fragment& f) {
    share.lane[k] = behind_.share_behind(index(x, y), f.depth);
  });
  const auto any = fragment_lanes::integers{} + lost.lanes.id[std::countr_zero(lost.set)];
  const fragment_lanes f{mask_of(lost.set).lane ? lost.lanes.id : any, lost.lanes.depth, lost.lanes.coverage * share,
                         lost.lanes.along};
  const fragment_lanes::pack alpha = has_translucency(shown_) ? alpha_of(from_.fibres(), f) : f.coverage;
  add_fragments(alpha, shades_.at(f), lost.set, tail_of, behind);
}

void camera_film::finish(int x, int y, std::span<const pixel_fragment> nearest, const tail& behind) {
  pixel_radiance<float> pixel = empty_pixel<float>();
  for (const pixel_fragment& f : nearest) {
    pixel = add_fibre(pixel, shades_.at(f.id, f.along), glm::vec3(1.0F - opacity(f)), visible_coverage(index(x, y), f));
  }
  pixel = add_tail(pixel, behind);
  picture_.at(x, y) = resolve(pixel, behind_fibres(x, y));
}

void camera_film::look_at(int x, int y, std::span<const pixel_fragment> all, std::vector<layer>& layers) const {
  layers.clear();
  for (const pixel_fragment& f : all) {
    layers.push_back({fragment_of(f), opacity(f) * visible_coverage(index(x, y), f), shades_.at(f.id, f.along)});
  }
}

}  // namespace pelage::frame
