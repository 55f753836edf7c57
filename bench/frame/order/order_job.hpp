// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>
#include <pelage/core/lane_moves.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "frame/base/compiled_sizes.hpp"
#include "frame/base/stopwatch.hpp"
#include "frame/order/order_pass.hpp"
#include "frame/raster/sweep.hpp"

/// What the methods of an order pass share. For order_pass.cpp and the methods' own files.
namespace pelage::frame {

/// One pass: where the fragments come from and where they go.
struct order_job {
  const raster& from;
  std::span<const float> limit;
  std::span<const std::uint32_t> drawing_order;
  pixel_visitor& visitor;
  order_report report;

  [[nodiscard]] std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(from.from().width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] std::size_t pixels() const { return pixel(0, from.from().height); }

  /// Calls `visit(x, y, pixel_fragment)` for the segments' fragments in `clip` that nothing opaque hides.
  template <class Visit>
  void for_each_visible(std::span<const std::uint32_t> segments, const pixel_rect& clip, Visit&& visit) const {
    from.for_each(segments, clip, [&](int x, int y, const pixel_fragment& f) {
      if (limit.empty() || !(f.depth >= limit[pixel(x, y)])) visit(x, y, f);
    });
  }

  /// Calls `visit(drawn_fragments)` for the same.
  template <class Visit>
  void for_each_visible_lanes(std::span<const std::uint32_t> segments, const pixel_rect& clip, Visit&& visit) const {
    from.for_each_lanes(segments, clip, [&](drawn_fragments found) {
      if (!limit.empty()) {
        const auto inside = found.y * from.from().width + found.x;
        const auto here = gathered<raster::width>(limit.data(), mask_of(found.set).lane ? inside : inside - inside);
        found.set &= ~bits(lane_mask<raster::width>{found.lanes.depth.lane >= here.lane});
        if (found.set == 0) return;
      }
      visit(found);
    });
  }

  /// Calls `visit(segments)` for all segments, some at a time, from all threads.
  template <class Visit>
  void for_each_batch(Visit&& visit) const {
    const tbb::blocked_range<std::uint32_t> all(0, from.fibres().segment_count(), 4096);
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::uint32_t>& some) {
      std::vector<std::uint32_t> segments(some.size());
      std::iota(segments.begin(), segments.end(), some.begin());
      if (!drawing_order.empty()) {
        std::copy_n(drawing_order.begin() + some.begin(), some.size(), segments.begin());
      }
      visit(std::span<const std::uint32_t>(segments));
    });
  }

  /// Calls `visit(x, y, fragment)` for the fragments of some segments.
  template <class Visit>
  void for_each_fragment_of(std::span<const std::uint32_t> segments, Visit&& visit) const {
    const pixel_rect whole{0, 0, from.from().width, from.from().height};
    for_each_visible(segments, whole, [&](int x, int y, const pixel_fragment& f) { visit(x, y, fragment_of(f)); });
  }

  /// Calls `visit(x, y, fragment)` for all fragments in no order, from all threads.
  template <class Visit>
  void for_each_fragment(Visit&& visit) const {
    for_each_batch([&](std::span<const std::uint32_t> segments) { for_each_fragment_of(segments, visit); });
  }

  template <class Visit>
  void for_each_pixel(Visit&& visit) const {
    tbb::parallel_for(0, from.from().height, [&](int y) {
      for (int x = 0; x < from.from().width; ++x)
        visit(x, y);
    });
  }
};

/// A pixel whose fragments are known by depth and id alone: finds them again and hands them to the visitor.
class pixel_resolver {
 public:
  std::vector<fragment> nearest;  ///< in order
  std::vector<fragment> lost;     ///< in none

  /// Empties both lists for the next pixel.
  void finish(const order_job& work, int x, int y) {
    behind_.assign(work.visitor.tails(), empty_tail());
    if (!lost.empty()) work.visitor.lose(x, y, look_up(work, x, y, lost), behind_);
    work.visitor.finish(x, y, look_up(work, x, y, nearest), behind_);
    nearest.clear();
    lost.clear();
  }

 private:
  std::span<const pixel_fragment> look_up(const order_job& work, int x, int y, std::span<const fragment> all) {
    seen_.clear();
    for (const fragment& f : all)
      seen_.push_back(work.from.at(f.id, x, y));
    return seen_;
  }

  std::vector<pixel_fragment> seen_;
  std::vector<tail> behind_;
};

/// Calls `run` with K as a std::integral_constant. Throws std::invalid_argument for one that is not compiled.
template <class Run>
void with_compiled_k(std::uint32_t k, Run&& run) {
  const auto constant = [&]<std::uint32_t K>() { run(std::integral_constant<std::uint32_t, K>{}); };
  if (!with_compiled_size<compiled_k>(k, constant)) {
    throw std::invalid_argument("k must be one of 1, 2, 4, 8, 16, 32, 64");
  }
}

}  // namespace pelage::frame
