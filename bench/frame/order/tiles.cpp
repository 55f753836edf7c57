// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order/tiles.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "frame/raster/occluder.hpp"
#include "frame/raster/sweep.hpp"

namespace pelage::frame {
namespace {

constexpr std::size_t chunk = 8192;  ///< segments that one task bins

/// Tiles, [x0, x1) × [y0, y1).
struct tile_range {
  std::uint16_t x0, y0, x1, y1;
};

tile_range tiles_of(const pixel_rect& r) {
  if (r.x0 >= r.x1 || r.y0 >= r.y1) return {0, 0, 0, 0};
  const auto tile = [](int pixel) { return static_cast<std::uint16_t>(pixel / tiles::side); };
  return {tile(r.x0), tile(r.y0), tile(r.x1 + tiles::side - 1), tile(r.y1 + tiles::side - 1)};
}

}  // namespace

tiles::tiles(const raster& from, std::span<const float> limit, std::span<const std::uint32_t> drawing_order)
    : width_(from.from().width),
      height_(from.from().height),
      across_((width_ + side - 1) / side),
      down_((height_ + side - 1) / side) {
  const std::size_t segments = from.fibres().segment_count();
  const std::size_t chunks = (segments + chunk - 1) / chunk;
  const auto tile_count = static_cast<std::size_t>(count());

  // Two rounds of the same walk, to count and to fill, so that each chunk knows where in a tile's list it begins.
  big_array<tile_range> touched(segments);
  std::vector<std::size_t> place(chunks * tile_count, 0);
  const auto walk = [&](std::size_t c, auto&& visit) {
    for (std::size_t i = c * chunk; i < std::min(segments, (c + 1) * chunk); ++i) {
      const std::uint32_t segment = drawing_order.empty() ? static_cast<std::uint32_t>(i) : drawing_order[i];
      const tile_range& r = touched[segment];
      for (int y = r.y0; y < r.y1; ++y) {
        for (int x = r.x0; x < r.x1; ++x) {
          visit(place[c * tile_count + static_cast<std::size_t>(y * across_ + x)], segment);
        }
      }
    }
  };
  const occluder hidden(from, limit);
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
    const std::size_t end = std::min(segments, (c + 1) * chunk);
    from.for_each_bounds(static_cast<std::uint32_t>(c * chunk), static_cast<std::uint32_t>(end),
                         [&](std::uint32_t s, const pixel_rect& box) {
                           touched[s] = hidden.hides(s, box) ? tile_range{0, 0, 0, 0} : tiles_of(box);
                         });
  });
  tbb::parallel_for(std::size_t{0}, chunks,
                    [&](std::size_t c) { walk(c, [](std::size_t& n, std::uint32_t) { ++n; }); });

  first_.assign(tile_count + 1, 0);
  std::size_t total = 0;
  for (std::size_t t = 0; t < tile_count; ++t) {
    first_[t] = total;
    for (std::size_t c = 0; c < chunks; ++c) {
      const std::size_t n = place[c * tile_count + t];
      place[c * tile_count + t] = total;
      total += n;
    }
  }
  first_[tile_count] = total;
  entry_.resize(total);
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
    walk(c, [&](std::size_t& n, std::uint32_t segment) { entry_[n++] = segment; });
  });
}

pixel_rect tiles::rect(int tile) const {
  const int x = tile % across_ * side;
  const int y = tile / across_ * side;
  return {x, y, std::min(x + side, width_), std::min(y + side, height_)};
}

std::span<const std::uint32_t> tiles::segments(int tile) const {
  const auto t = static_cast<std::size_t>(tile);
  return std::span(entry_).subspan(first_[t], first_[t + 1] - first_[t]);
}

std::size_t tiles::bytes() const {
  return entry_.capacity() * sizeof(std::uint32_t) + first_.capacity() * sizeof(std::size_t);
}

}  // namespace pelage::frame
