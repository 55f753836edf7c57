// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/camera_film.hpp"

#include <pelage/composite/divided_pixel.hpp>
#include <pelage/composite/tail_lanes.hpp>
#include <pelage/visibility/layer_position.hpp>

#include <bit>

#include "frame/raster/fragment_lanes.hpp"

namespace pelage::frame {

camera_film::camera_film(const raster& from, const backdrop& behind, const shaded_fibres& shades, components shown,
                         std::uint32_t slices)
    : from_(from),
      behind_(behind),
      shades_(shades),
      shown_(shown),
      slices_(slices),
      depths_(slices > 1 ? from.seen_depths(behind.limit()) : depth_range::empty()),
      picture_(behind.picture()) {
}

std::size_t camera_film::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
}

float camera_film::opacity(const pixel_fragment& f) const {
  return has_translucency(shown_) ? from_.opacity().at(f.id, f.along) : 1.0F;
}

std::uint32_t camera_film::slice_of(float depth) const {
  return slices_ > 1 ? layer_at(slice_position(depths_.relative(depth), slices_), slices_) : 0;
}

void camera_film::lose(int x, int y, std::span<const pixel_fragment> lost, std::span<tail> behind) {
  if (slices_ == 0) return;
  const float edge = behind_.edge()[index(x, y)];
  for (const pixel_fragment& f : lost) {
    tail& t = behind[slice_of(f.depth) + (f.depth < edge ? 0 : slices_)];
    t = add_fragment(t, opacity(f) * f.coverage, shades_.at(f.id, f.along));
  }
}

void camera_film::lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                             std::span<tail> behind) {
  if (slices_ == 0) return;
  const auto any = fragment_lanes::integers{} + lost.lanes.id[std::countr_zero(lost.set)];
  const auto is_set = mask_of(lost.set).lane;
  const fragment_lanes f{is_set ? lost.lanes.id : any, lost.lanes.depth, lost.lanes.coverage, lost.lanes.along};
  const fragment_lanes::pack alpha = has_translucency(shown_) ? from_.opacity().alpha(f) : f.coverage;

  const fragment_lanes::integers pixel = lost.y * picture_.width + lost.x;
  const fragment_lanes::integers inside = is_set ? pixel : pixel - pixel;
  const std::uint32_t before = bits(f.depth < gathered<raster::width>(behind_.edge().data(), inside));
  std::array<std::uint32_t, raster::width> part_of = tail_of;
  const std::uint32_t apart = slices_ > 1 ? lost.set : lost.set & ~before;
  for_each_lane(apart, [&](int k) {
    part_of[static_cast<std::size_t>(k)] += slice_of(f.depth.lane[k]) + ((before >> k & 1U) != 0 ? 0 : slices_);
  });
  add_fragments(alpha, shades_.at(f), lost.set, part_of, behind);
}

void camera_film::finish(int x, int y, std::span<const pixel_fragment> nearest, std::span<const tail> behind) {
  if (nearest.empty()) return;  // the background is there already
  const divided_backdrop<float> backdrop = behind_.at(index(x, y));
  divided_pixel<float> pixel = empty_divided_pixel<float>();
  for (const pixel_fragment& f : nearest) {
    pixel =
        add_fibre(pixel, f.depth < backdrop.edge, shades_.at(f.id, f.along), glm::vec3(1.0F - opacity(f)), f.coverage);
  }
  const std::size_t slices = behind.size() / 2;
  for (std::size_t slice = 0; slice < slices; ++slice)
    pixel = add_tails(pixel, behind[slice], behind[slices + slice]);
  picture_.at(x, y) = resolve(pixel, backdrop);
}

}  // namespace pelage::frame
