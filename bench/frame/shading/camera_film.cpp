// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/camera_film.hpp"

#include <pelage/composite/divided_pixel.hpp>
#include <pelage/composite/tail_lanes.hpp>

#include <bit>

#include "frame/raster/fragment_lanes.hpp"

namespace pelage::frame {

camera_film::camera_film(const raster& from, const backdrop& behind, const shaded_fibres& shades, components shown)
    : from_(from),
      behind_(behind),
      shades_(shades),
      shown_(shown),
      behind_edge_(behind.edge().size(), empty_tail()),
      picture_(behind.picture()) {
}

std::size_t camera_film::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
}

float camera_film::opacity(const pixel_fragment& f) const {
  return has_translucency(shown_) ? from_.mix(from_.fibres().opacity, f.id, f.along) : 1.0F;
}

void camera_film::lose(int x, int y, std::span<const pixel_fragment> lost, tail& behind) {
  const std::size_t pixel = index(x, y);
  for (const pixel_fragment& f : lost) {
    tail& part = f.depth < behind_.edge()[pixel] ? behind : behind_edge_[pixel];
    part = add_fragment(part, opacity(f) * f.coverage, shades_.at(f.id, f.along));
  }
}

void camera_film::lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                             std::span<tail> behind) {
  const auto any = fragment_lanes::integers{} + lost.lanes.id[std::countr_zero(lost.set)];
  const auto is_set = mask_of(lost.set).lane;
  const fragment_lanes f{is_set ? lost.lanes.id : any, lost.lanes.depth, lost.lanes.coverage, lost.lanes.along};
  const fragment_lanes::pack alpha = has_translucency(shown_) ? alpha_of(from_.fibres(), f) : f.coverage;
  const auto shade = shades_.at(f);

  const fragment_lanes::integers pixel = lost.y * picture_.width + lost.x;
  const fragment_lanes::integers inside = is_set ? pixel : pixel - pixel;
  const std::uint32_t before = lost.set & bits(f.depth < gathered<raster::width>(behind_.edge().data(), inside));
  add_fragments(alpha, shade, before, tail_of, behind);
  if (before == lost.set) return;
  std::array<std::uint32_t, raster::width> pixel_of;
  __builtin_memcpy(pixel_of.data(), &inside, sizeof(inside));
  add_fragments(alpha, shade, lost.set & ~before, pixel_of, behind_edge_);
}

void camera_film::finish(int x, int y, std::span<const pixel_fragment> nearest, const tail& behind) {
  if (nearest.empty()) return;  // the background is there already
  const std::size_t here = index(x, y);
  const divided_backdrop<float> backdrop = behind_.at(here);
  divided_pixel<float> pixel = empty_divided_pixel<float>();
  for (const pixel_fragment& f : nearest) {
    pixel =
        add_fibre(pixel, f.depth < backdrop.edge, shades_.at(f.id, f.along), glm::vec3(1.0F - opacity(f)), f.coverage);
  }
  picture_.at(x, y) = resolve(add_tails(pixel, behind, behind_edge_[here]), backdrop);
}

}  // namespace pelage::frame
