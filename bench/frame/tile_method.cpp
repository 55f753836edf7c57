// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/k_select.hpp>
#include <pelage/order/slot_storage.hpp>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "frame/group_by_pixel.hpp"
#include "frame/order_job.hpp"
#include "frame/seen_lanes.hpp"
#include "frame/tiles.hpp"

/// The method that has one thread draw a tile, whose fragments stay in its cache.
namespace pelage::frame {
namespace {

/// What one thread needs for a tile. Fragments are gathered, without regard to pixels, in an array of fixed size;
/// whenever it is full, and at the end, they are put in order by pixel, and each pixel keeps the K nearest.
template <std::uint32_t K>
class tile_worker {
 public:
  std::uint64_t fragments = 0;
  std::uint64_t behind = 0;
  std::uint32_t longest = 0;

  void run(const order_job& work, const pixel_rect& rect, std::span<const std::uint32_t> segments) {
    std::fill(count_.begin(), count_.end(), 0);
    std::fill(held_.begin(), held_.end(), 0);
    std::fill(behind_.begin(), behind_.end(), empty_tail());
    work.for_each_visible_lanes(segments, rect, [&](const raster::touches& found) {
      const auto pixel = (found.y - rect.y0) * tiles::side + (found.x - rect.x0);
      const floats left = packed_left(found.set, floats(reinterpret_cast<floats::vector>(pixel)));
      const auto narrow = __builtin_convertvector(reinterpret_cast<floats::integers>(left.lane), pixel_numbers);
      __builtin_memcpy(&pixel_of_[arrived_count_], &narrow, sizeof(narrow));
      const seen_lanes seen{found.segment, found.depth, found.coverage, found.along};
      seen.packed_left(found.set).store(&arrived_[arrived_count_]);
      arrived_count_ += static_cast<std::size_t>(std::popcount(found.set));
      if (arrived_count_ >= capacity) flush(work, rect);
    });
    flush(work, rect);
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x)
        finish(work, x, y, static_cast<std::size_t>((y - rect.y0) * tiles::side + (x - rect.x0)));
    }
  }

  [[nodiscard]] static constexpr std::size_t bytes() {
    return capacity * (sizeof(std::uint16_t) + 2 * sizeof(seen_fragment) + sizeof(fragment) + sizeof(seen_fragment)) +
           pixels * (K * sizeof(seen_fragment) + 3 * sizeof(std::uint32_t) + sizeof(tail));
  }

 private:
  using floats = seen_lanes::pack;
  typedef std::uint16_t pixel_numbers __attribute__((vector_size(2 * seen_lanes::width)));

  static constexpr std::size_t pixels = static_cast<std::size_t>(tiles::side) * tiles::side;
  static constexpr std::size_t capacity = std::size_t{1} << 15;
  static constexpr std::size_t width = seen_lanes::width;  ///< so many more are written, the last in vain

  void flush(const order_job& work, const pixel_rect& rect) {
    group_by_pixel(std::span<const std::uint16_t>(pixel_of_).first(arrived_count_),
                   std::span(arrived_).first(arrived_count_), by_pixel_, std::span(end_));
    arrived_count_ = 0;

    std::uint32_t begin = 0;
    for (std::size_t p = 0; p < pixels; ++p) {
      const std::uint32_t end = end_[p];
      if (end > begin) keep_nearest(work, rect, p, std::span(by_pixel_).subspan(begin, end - begin));
      begin = end;
    }
  }

  /// Of the fragments that the pixel holds and the new ones, keeps the K nearest, in no order.
  void keep_nearest(const order_job& work, const pixel_rect& rect, std::size_t p,
                    std::span<const seen_fragment> arrived) {
    const std::span<seen_fragment> kept = std::span(kept_).subspan(p * K, K);
    const std::uint32_t held = held_[p];
    count_[p] += static_cast<std::uint32_t>(arrived.size());
    if (held + arrived.size() <= K) {
      std::copy(arrived.begin(), arrived.end(), kept.begin() + held);
      held_[p] += static_cast<std::uint32_t>(arrived.size());
      return;
    }
    std::size_t count = 0;
    for (const std::span<const seen_fragment> some : {std::span<const seen_fragment>(kept.first(held)), arrived}) {
      for (std::size_t i = 0; i < some.size(); i += width)
        seen_lanes::load(&some[i]).store_fragments(&all_[count + i]);
      count += some.size();
    }
    std::array<fragment, K> nearest;
    k_select<K>({all_.data(), count}, std::span(nearest));

    std::array<seen_fragment, K + width> stay;
    std::size_t staying = 0;
    std::size_t going = 0;
    const auto sort_out = [&](std::span<const seen_fragment> some) {
      for (std::size_t i = 0; i < some.size(); i += width) {
        const std::uint32_t all =
            i + width <= some.size() ? all_bits<seen_lanes::width>() : (1U << (some.size() - i)) - 1U;
        const seen_lanes f = seen_lanes::load(&some[i]);
        const std::uint32_t goes = f.behind(nearest[K - 1]) & all;
        f.packed_left(all & ~goes).store(&stay[staying]);
        f.packed_left(goes).store(&lost_[going]);
        staying += static_cast<std::size_t>(std::popcount(all & ~goes));
        going += static_cast<std::size_t>(std::popcount(goes));
      }
    };
    sort_out(kept.first(held));
    sort_out(arrived);
    std::copy_n(stay.begin(), K, kept.begin());
    held_[p] = K;
    const int side = tiles::side;
    work.visitor.lose(rect.x0 + static_cast<int>(p) % side, rect.y0 + static_cast<int>(p) / side,
                      std::span(lost_).first(going), behind_[p]);
  }

  /// Puts what the pixel holds in order: a fragment's place is the number of those before it.
  void finish(const order_job& work, int x, int y, std::size_t p) {
    const std::span<const seen_fragment> kept = std::span(kept_).subspan(p * K, held_[p]);
    std::array<std::uint64_t, K> key;
    key.fill(pack(no_fragment()));
    for (std::size_t i = 0; i < kept.size(); ++i)
      key[i] = pack(fragment_of(kept[i]));
    std::array<std::uint64_t, K> place{};
    for (std::size_t i = 0; i < K; ++i) {
      for (std::size_t j = 0; j < K; ++j)
        place[j] += key[i] < key[j] ? 1U : 0U;
    }
    std::array<seen_fragment, K> sorted;
    for (std::size_t i = 0; i < kept.size(); ++i)
      sorted[place[i]] = kept[i];
    fragments += count_[p];
    behind += count_[p] - kept.size();
    longest = std::max(longest, count_[p]);
    work.visitor.finish(x, y, std::span(sorted).first(kept.size()), behind_[p]);
  }

  std::size_t arrived_count_ = 0;
  std::vector<std::uint16_t> pixel_of_ = std::vector<std::uint16_t>(capacity + width);
  std::vector<seen_fragment> arrived_ = std::vector<seen_fragment>(capacity + width);
  std::vector<seen_fragment> by_pixel_ = std::vector<seen_fragment>(capacity + width);
  std::vector<fragment> all_ = std::vector<fragment>(capacity + K + width);
  std::vector<seen_fragment> lost_ = std::vector<seen_fragment>(capacity + K + 2 * width);
  std::vector<std::uint32_t> end_ = std::vector<std::uint32_t>(pixels);    ///< where each pixel's arrivals end
  std::vector<std::uint32_t> count_ = std::vector<std::uint32_t>(pixels);  ///< of all its fragments
  std::vector<std::uint32_t> held_ = std::vector<std::uint32_t>(pixels);   ///< of those, kept
  std::vector<seen_fragment> kept_ = std::vector<seen_fragment>(pixels * K + width);
  std::vector<tail> behind_ = std::vector<tail>(pixels);
};

template <std::uint32_t K>
void run_tiles(order_job& work) {
  stopwatch watch;
  const tiles bins(work.from, work.limit, work.drawing_order);
  work.report.bin_seconds = watch.lap();
  tbb::enumerable_thread_specific<tile_worker<K>> workers;
  tbb::parallel_for(0, bins.count(), [&](int t) { workers.local().run(work, bins.rect(t), bins.segments(t)); });
  work.report.build_seconds = watch.lap();
  for (const tile_worker<K>& one : workers) {
    work.report.fragments += one.fragments;
    work.report.behind += one.behind;
    work.report.longest = std::max(work.report.longest, one.longest);
  }
  work.report.bytes = bins.bytes() + workers.size() * tile_worker<K>::bytes();
}

}  // namespace

void run_k_buffer(order_job& work, std::uint32_t k) {
  with_compiled_k(k, [&](auto constant) { run_tiles<decltype(constant)::value>(work); });
}

}  // namespace pelage::frame
