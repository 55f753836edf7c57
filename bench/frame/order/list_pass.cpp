// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order/list_pass.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "frame/order/group_by_pixel.hpp"
#include "frame/order/order_job.hpp"
#include "frame/order/tiles.hpp"
#include "frame/raster/sweep.hpp"

namespace pelage::frame {
namespace {

/// The fragments of a tile, grouped by pixel.
class tile_lists {
 public:
  void draw(const raster& from, std::span<const float> limit, const pixel_rect& rect,
            std::span<const std::uint32_t> segments) {
    const std::size_t width = static_cast<std::size_t>(from.from().width);
    pixel_.clear();
    arrived_.clear();
    from.for_each(segments, rect, [&](int x, int y, const pixel_fragment& f) {
      const std::size_t in_picture = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      if (!limit.empty() && f.depth >= limit[in_picture]) return;
      if (!is_fragment(fragment_of(f))) {
        ++report.refused;
        return;
      }
      pixel_.push_back(static_cast<std::uint32_t>((y - rect.y0) * tiles::side + (x - rect.x0)));
      arrived_.push_back(f);
    });
    grouped_.resize(arrived_.size());
    std::fill(end_.begin(), end_.end(), 0);
    group_by_pixel(std::span<const std::uint32_t>(pixel_), std::span(end_),
                   [&](std::size_t i, std::size_t place) { grouped_[place] = arrived_[i]; });
    report.fragments += arrived_.size();
    report.bytes =
        std::max(report.bytes, pixel_.size() * sizeof(std::uint32_t) + 2 * arrived_.size() * sizeof(pixel_fragment));
  }

  void visit(const pixel_rect& rect, const list_visitor& visitor) {
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        const std::size_t p = static_cast<std::size_t>((y - rect.y0) * tiles::side + (x - rect.x0));
        const std::size_t begin = p == 0 ? 0 : end_[p - 1];
        const std::span<pixel_fragment> all = std::span(grouped_).subspan(begin, end_[p] - begin);
        report.longest = std::max(report.longest, static_cast<std::uint32_t>(all.size()));
        visitor(x, y, all);
      }
    }
  }

  order_report report;

 private:
  std::vector<std::uint32_t> pixel_;
  std::vector<pixel_fragment> arrived_;
  std::vector<pixel_fragment> grouped_;
  std::vector<std::size_t> end_ = std::vector<std::size_t>(static_cast<std::size_t>(tiles::side) * tiles::side);
};

}  // namespace

order_report run_list_pass(const raster& from, std::span<const float> limit,
                           std::span<const std::uint32_t> drawing_order, const list_visitor& visit) {
  order_report report;
  stopwatch watch;
  const tiles bins(from, limit, drawing_order);
  report.bin_seconds = watch.lap();
  tbb::enumerable_thread_specific<tile_lists> scratch;
  tbb::parallel_for(0, bins.count(), [&](int t) {
    tile_lists& mine = scratch.local();
    mine.draw(from, limit, bins.rect(t), bins.segments(t));
    mine.visit(bins.rect(t), visit);
  });
  report.build_seconds = watch.lap();
  report.bytes = bins.bytes();
  for (const tile_lists& one : scratch) {
    report.fragments += one.report.fragments;
    report.refused += one.report.refused;
    report.longest = std::max(report.longest, one.report.longest);
    report.bytes += one.report.bytes;
  }
  return report;
}

}  // namespace pelage::frame
