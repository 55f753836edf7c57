// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lane_moves.hpp>
#include <pelage/core/lanes.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>

#include "frame/raster/raster.hpp"

namespace pelage::frame {

/// A vector's worth of segments, one to a lane, and the pixels near them that wait to be looked at. Pixels of different
/// segments go through the kernels together, each with its segment's lane, so that nearly all lanes work.
class raster::sweep {
 public:
  sweep(const raster& from, const pixel_rect& clip) : from_(from), clip_(clip) {}

  /// Calls `visit(drawn_fragments)` for those of at most `width` segments.
  template <class Visit>
  void draw(std::span<const std::uint32_t> segments, Visit&& visit);

  /// Calls `visit(segment, bounds)` for those of at most `width` segments.
  template <class Visit>
  void bound(std::span<const std::uint32_t> segments, Visit&& visit);

 private:
  using pack = lanes<width>;
  using integers = pack::integers;

  void load(std::span<const std::uint32_t> segments);

  /// Queues the pixels near one of the segments; calls `look(first, count)` for those that wait, before there are too
  /// many.
  template <class Look>
  void queue(int lane, const outline<float>& near, Look&& look);

  /// The same for as many as fill vectors.
  template <class Look>
  void look_at_whole(Look&& look);

  /// What the segments leave in the pixels of `place` that wait there.
  [[nodiscard]] drawn_fragments drawn_at(integers place) const;

  [[nodiscard]] static integers whole_numbers(pack x) { return __builtin_convertvector(x.lane, integers); }
  [[nodiscard]] static pack as_floats(integers x) { return pack(__builtin_convertvector(x, pack::vector)); }
  static void store(integers x, int* to) { __builtin_memcpy(to, &x, sizeof(x)); }
  [[nodiscard]] static integers load(const int* from) {
    integers x;
    __builtin_memcpy(&x, from, sizeof(x));
    return x;
  }

  /// A waiting pixel in one number: its segment's lane, y and x. A view's sides are at most 2¹⁴.
  static constexpr int coordinate_bits = 14;
  static constexpr int coordinate_mask = (1 << coordinate_bits) - 1;

  static constexpr int rows_at_most = width * width;  ///< pixels that are queued without a look at how many wait
  static constexpr int capacity = 2 * rows_at_most;

  const raster& from_;
  pixel_rect clip_;
  integers number_;  ///< of each segment
  projected_point<pack> start_, end_;
  alignas(64) std::array<int, capacity + width> waiting_;
  int count_ = 0;
};

// ---------------------------------------------------------------------------------------------------------

template <class Visit>
void raster::for_each_lanes(std::span<const std::uint32_t> segments, const pixel_rect& clip, Visit&& visit) const {
  sweep one(*this, clip);
  constexpr std::size_t step = width;
  for (std::size_t i = 0; i < segments.size(); i += step) {
    for (std::size_t ahead = i + step; ahead < std::min(i + 2 * step, segments.size()); ++ahead)
      __builtin_prefetch(&point_[fibres_.segment[segments[ahead]]]);
    one.draw(segments.subspan(i, std::min(step, segments.size() - i)), visit);
  }
}

template <class Visit>
void raster::for_each(std::span<const std::uint32_t> segments, const pixel_rect& clip, Visit&& visit) const {
  for_each_lanes(segments, clip, [&](const drawn_fragments& found) {
    for_each_drawn(found, [&](std::size_t, int x, int y, const pixel_fragment& f) { visit(x, y, f); });
  });
}

template <class Visit>
void raster::for_each_bounds(std::uint32_t begin, std::uint32_t end, Visit&& visit) const {
  sweep one(*this, {0, 0, 0, 0});
  std::array<std::uint32_t, width> segments;
  for (std::uint32_t s = begin; s < end; s += width) {
    std::iota(segments.begin(), segments.end(), s);
    one.bound(std::span(segments).first(std::min<std::size_t>(width, end - s)), visit);
  }
}

template <class Visit>
void raster::sweep::bound(std::span<const std::uint32_t> segments, Visit&& visit) {
  load(segments);
  const outline<pack> near = outline_of(start_, end_, from_.view_, from_.stretch_);
  const integers x0 = whole_numbers(near.x0);
  const integers y0 = whole_numbers(near.y0);
  const integers x1 = whole_numbers(near.x1);
  const integers y1 = whole_numbers(near.y1);
  const std::uint32_t wide = bits(near.fails > pack(0.0F));
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const bool is_wide = (wide >> k & 1U) != 0;
    visit(segments[k], is_wide ? from_.bounds(segments[k]) : pixel_rect{x0[k], y0[k], x1[k], y1[k]});
  }
}

template <class Visit>
void raster::sweep::draw(std::span<const std::uint32_t> segments, Visit&& visit) {
  load(segments);
  const outline<pack> near = outline_of(start_, end_, from_.view_, from_.stretch_);
  alignas(64) float x0[width], y0[width], x1[width], y1[width], x[width], y[width], slope[width], half[width];
  const pixel_rect& c = clip_;
  const auto within = [](pack value, int low, int high) { return least(greatest(value, pack(low)), pack(high)); };
  within(near.x0, c.x0, c.x1).store(x0);
  within(near.y0, c.y0, c.y1).store(y0);
  within(near.x1, c.x0, c.x1).store(x1);
  within(near.y1, c.y0, c.y1).store(y1);
  near.x.store(x);
  near.y.store(y);
  near.slope.store(slope);
  near.half.store(half);

  const auto look = [&](int first, int count) {
    drawn_fragments found = drawn_at(load(waiting_.data() + first));
    if (count < width) found.set &= (1U << count) - 1U;
    if (found.set != 0) visit(found);
  };
  const std::uint32_t wide = bits(near.fails > pack(0.0F));
  for (std::size_t k = 0; k < segments.size(); ++k) {
    outline<float> one{x0[k], y0[k], x1[k], y1[k], x[k], y[k], slope[k], half[k], 0.0F};
    if ((wide >> k & 1U) != 0) one = from_.wide_outline_of(segments[k]);
    queue(static_cast<int>(k), one, look);
  }
  look_at_whole(look);
  if (count_ > 0) look(0, count_);
  count_ = 0;
}

template <class Look>
void raster::sweep::look_at_whole(Look&& look) {
  int first = 0;
  for (; first + width <= count_; first += width)
    look(first, width);
  count_ -= first;
  store(load(waiting_.data() + first), waiting_.data());
}

inline void raster::sweep::load(std::span<const std::uint32_t> segments) {
  constexpr int members = sizeof(projected) / sizeof(float);
  std::array<const float*, width> points;
  for (std::size_t k = 0; k < width; ++k) {
    const std::uint32_t segment = segments[std::min(k, segments.size() - 1)];
    number_[k] = static_cast<int>(segment);
    points[k] = &from_.point_[from_.fibres_.segment[segment]].x;
  }
  pack member[2 * members];
  for (int m = 0; m < 2 * members; m += width) {
    pack rows[width];
    for (std::size_t k = 0; k < width; ++k)
      rows[k] = pack::load(points[k] + m);
    transpose(rows);
    std::copy_n(rows, width, member + m);
  }
  start_ = {member[0], member[1], member[2], member[3], member[4], member[5], member[6], member[7]};
  end_ = {member[8], member[9], member[10], member[11], member[12], member[13], member[14], member[15]};
}

template <class Look>
void raster::sweep::queue(int lane, const outline<float>& near, Look&& look) {
  const float x0 = std::max(near.x0, static_cast<float>(clip_.x0));
  const float x1 = std::min(near.x1, static_cast<float>(clip_.x1));
  if (x0 >= x1) return;
  const pack low(x0);
  const pack high(x1);
  const int y0 = std::max(static_cast<int>(near.y0), clip_.y0);
  const int y1 = std::min(static_cast<int>(near.y1), clip_.y1);
  for (int y = y0; y < y1; y += width) {
    const pack centre = as_floats(counted_lanes()) + pack(static_cast<float>(y) + 0.5F);
    const pack crossing = pack(near.x) + (centre - pack(near.y)) * pack(near.slope);
    const integers left = whole_numbers(first_centre_from(crossing - pack(near.half), low, high));
    const integers right = whole_numbers(first_centre_from(crossing + pack(near.half), low, high));
    const integers first = left + (((lane << coordinate_bits) + y + counted_lanes()) << coordinate_bits);
    alignas(64) int places[width];
    alignas(64) int counts[width];
    store(first, places);
    store(right - left, counts);
    const int rows = std::min(y1 - y, width);
    for (int row = 0; row < rows; ++row) {
      int place = places[row];
      int rest = counts[row];
      for (; rest > width; rest -= width, place += width) {
        store(counted_lanes() + place, waiting_.data() + count_);
        count_ += width;
        look_at_whole(look);
      }
      store(counted_lanes() + place, waiting_.data() + count_);
      count_ += rest;
    }
    if (count_ >= capacity - rows_at_most) look_at_whole(look);
  }
}

inline drawn_fragments raster::sweep::drawn_at(integers place) const {
  const integers lane = place >> (2 * coordinate_bits) & (width - 1);
  const integers row = place >> coordinate_bits & coordinate_mask;
  const integers column = place & coordinate_mask;
  const auto own = [lane](const projected_point<pack>& p) {
    return projected_point<pack>{picked(p.x, lane),       picked(p.y, lane),       picked(p.z, lane),
                                 picked(p.radius, lane),  picked(p.pixel_x, lane), picked(p.pixel_y, lane),
                                 picked(p.joint_x, lane), picked(p.joint_y, lane)};
  };
  const auto found = from_.look(own(start_), own(end_), as_floats(column) + pack(0.5F), as_floats(row) + pack(0.5F));
  return {bits(found.coverage > pack(0.0F)),
          column,
          row,
          {picked_integers<width>(number_, lane), found.depth, found.coverage, found.along}};
}

}  // namespace pelage::frame
