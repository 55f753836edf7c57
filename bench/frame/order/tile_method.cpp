// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/k_select.hpp>
#include <pelage/order/packed_fragment.hpp>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "frame/order/group_by_pixel.hpp"
#include "frame/order/methods.hpp"
#include "frame/order/order_job.hpp"
#include "frame/order/tiles.hpp"
#include "frame/raster/fragment_lanes.hpp"

/// The method that has one thread draw a tile, whose fragments stay in its cache.
namespace pelage::frame {
namespace {

/// What one thread needs for a tile. Fragments are gathered in an array of fixed size; whenever it is full, and at the
/// end, the last of each pixel's K nearest is found, and those behind it go to the tail, in the order in which they
/// came: one strand's fragments, which share what is looked up for them, are still together. Later ones behind it go
/// there at once.
template <std::uint32_t K>
class tile_worker {
 public:
  std::uint64_t fragments = 0;
  std::uint64_t behind = 0;
  std::uint64_t refused = 0;
  std::uint32_t longest = 0;

  void run(const order_job& work, const pixel_rect& rect, std::span<const std::uint32_t> segments) {
    std::fill(count_.begin(), count_.end(), 0);
    std::fill(held_.begin(), held_.end(), 0);
    std::fill(last_key_.begin(), last_key_.end(), depth_key(no_fragment().depth));
    std::fill(last_id_.begin(), last_id_.end(), no_fragment().id);
    tails_ = work.visitor.tails();
    behind_.assign(pixels * tails_, empty_tail());
    knows_last_ = false;
    work.for_each_visible_lanes(segments, rect, [&](drawn_fragments found) {
      const floats infinite(std::numeric_limits<float>::infinity());
      const std::uint32_t nan =
          found.set & ~(bits(found.lanes.depth < infinite) | bits(found.lanes.depth > floats(0.0F)));
      refused += static_cast<std::uint64_t>(std::popcount(nan));
      found.set &= ~nan;
      const integers pixel =
          ((found.y - rect.y0) * tiles::side + (found.x - rect.x0)) & static_cast<int>(pixels - 1);  // unset lanes, too
      if (knows_last_) found.set &= ~lose_behind(work, found, pixel);
      const floats left = packed_left(found.set, floats(reinterpret_cast<floats::vector>(pixel)));
      const auto narrow = __builtin_convertvector(reinterpret_cast<integers>(left.lane), pixel_numbers);
      __builtin_memcpy(&pixel_of_[arrived_count_], &narrow, sizeof(narrow));
      found.lanes.packed_left(found.set).store(&arrived_[arrived_count_]);
      arrived_count_ += static_cast<std::size_t>(std::popcount(found.set));
      if (arrived_count_ >= capacity) flush(work, rect);
    });
    flush(work, rect);
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x)
        finish(work, x, y, static_cast<std::size_t>((y - rect.y0) * tiles::side + (x - rect.x0)));
    }
  }

  [[nodiscard]] std::size_t bytes() const {
    return capacity * (sizeof(std::uint16_t) + sizeof(pixel_fragment) + sizeof(fragment)) +
           pixels * (K * (sizeof(pixel_fragment) + sizeof(fragment)) + 5 * sizeof(std::uint32_t)) +
           behind_.size() * sizeof(tail);
  }

 private:
  using floats = fragment_lanes::pack;
  using integers = floats::integers;
  using naturals = floats::naturals;
  typedef std::uint16_t pixel_numbers __attribute__((vector_size(2 * fragment_lanes::width)));

  static constexpr std::size_t pixels = static_cast<std::size_t>(tiles::side) * tiles::side;
  static constexpr std::size_t capacity = std::size_t{1} << 15;
  static constexpr std::size_t width = fragment_lanes::width;  ///< so many more are written, the last in vain

  [[nodiscard]] static naturals gathered_words(const std::vector<std::uint32_t>& from, integers at) {
    return reinterpret_cast<naturals>(
        gathered<fragment_lanes::width>(reinterpret_cast<const float*>(from.data()), at).lane);
  }

  /// Hands on the fragments that are behind the last of their pixel's K nearest; returns their bits.
  std::uint32_t lose_behind(const order_job& work, drawn_fragments all, integers pixel) {
    all.set &= all.lanes.behind(gathered_words(last_key_, pixel), gathered_words(last_id_, pixel));
    if (all.set == 0) return 0;
    std::array<std::uint32_t, width> tail_of;
    __builtin_memcpy(tail_of.data(), &pixel, sizeof(pixel));
    for (std::uint32_t left = all.set; left != 0; left &= left - 1U)
      ++count_[tail_of[static_cast<std::size_t>(std::countr_zero(left))]];
    const integers first = pixel * static_cast<int>(tails_);
    __builtin_memcpy(tail_of.data(), &first, sizeof(first));
    work.visitor.lose_lanes(all, tail_of, behind_);
    return all.set;
  }

  [[nodiscard]] std::span<tail> tails_of(std::size_t p) { return std::span(behind_).subspan(p * tails_, tails_); }

  void flush(const order_job& work, const pixel_rect& rect) {
    const std::span<const std::uint16_t> pixel_of = std::span(pixel_of_).first(arrived_count_);
    std::copy(held_.begin(), held_.end(), end_.begin());
    group_by_pixel(pixel_of, std::span(end_),
                   [&](std::size_t i, std::uint32_t place) { by_pixel_[place] = fragment_of(arrived_[i]); });
    std::uint32_t begin = 0;
    for (std::size_t p = 0; p < pixels; ++p) {
      const std::uint32_t held = held_[p];
      if (end_[p] > begin) find_last(work, rect, p, std::span(by_pixel_).subspan(begin, end_[p] + held - begin));
      begin = end_[p] + held;
    }
    knows_last_ = true;

    for (std::size_t i = 0; i < arrived_count_; i += width) {
      const std::size_t some = std::min(arrived_count_ - i, width);
      pixel_numbers narrow;
      __builtin_memcpy(&narrow, &pixel_of_[i], sizeof(narrow));
      const integers pixel = __builtin_convertvector(narrow, integers) & static_cast<int>(pixels - 1);
      const fragment_lanes f = fragment_lanes::load(&arrived_[i]);
      const std::uint32_t all = (2U << (some - 1)) - 1U;
      const std::uint32_t lost =
          lose_behind(work, {all, pixel % tiles::side + rect.x0, pixel / tiles::side + rect.y0, f}, pixel);
      for (std::uint32_t left = all & ~lost; left != 0; left &= left - 1U) {
        const std::size_t k = i + static_cast<std::size_t>(std::countr_zero(left));
        const std::size_t p = pixel_of_[k];
        kept_[p * K + held_[p]++] = arrived_[k];
      }
    }
    arrived_count_ = 0;
  }

  /// `all`: the new fragments, and room for those that the pixel holds. Finds the last of the K nearest, and lets go of
  /// what it held behind that one.
  void find_last(const order_job& work, const pixel_rect& rect, std::size_t p, std::span<fragment> all) {
    const std::span<pixel_fragment> kept = std::span(kept_).subspan(p * K, held_[p]);
    if (all.size() < K) return;
    std::transform(kept.begin(), kept.end(), all.end() - static_cast<std::ptrdiff_t>(kept.size()), fragment_of);
    std::array<fragment, K> nearest;
    k_select<K>(all, std::span(nearest));
    const fragment last = nearest[K - 1];
    last_key_[p] = depth_key(last.depth);
    last_id_[p] = last.id;

    std::array<pixel_fragment, K> lost;
    std::size_t going = 0;
    std::size_t staying = 0;
    for (const pixel_fragment& f : kept) {
      const bool goes = before(last, fragment_of(f));
      lost[going] = f;
      kept[staying] = f;
      going += goes ? 1U : 0U;
      staying += goes ? 0U : 1U;
    }
    held_[p] = static_cast<std::uint32_t>(staying);
    count_[p] += static_cast<std::uint32_t>(going);
    if (going == 0) return;
    const int side = tiles::side;
    work.visitor.lose(rect.x0 + static_cast<int>(p) % side, rect.y0 + static_cast<int>(p) / side,
                      std::span(lost).first(going), tails_of(p));
  }

  /// Puts what the pixel holds in order: a fragment's place is the number of those before it.
  void finish(const order_job& work, int x, int y, std::size_t p) {
    const std::span<const pixel_fragment> kept = std::span(kept_).subspan(p * K, held_[p]);
    std::array<std::uint64_t, K> key;
    key.fill(pack(no_fragment()));
    for (std::size_t i = 0; i < kept.size(); ++i)
      key[i] = pack(fragment_of(kept[i]));
    std::array<std::uint64_t, K> place{};
    for (std::size_t i = 0; i < K; ++i) {
      for (std::size_t j = 0; j < K; ++j)
        place[j] += key[i] < key[j] ? 1U : 0U;
    }
    std::array<pixel_fragment, K> sorted;
    for (std::size_t i = 0; i < kept.size(); ++i)
      sorted[place[i]] = kept[i];
    const std::uint32_t count = count_[p] + held_[p];
    fragments += count;
    behind += count_[p];
    longest = std::max(longest, count);
    work.visitor.finish(x, y, std::span(sorted).first(kept.size()), tails_of(p));
  }

  bool knows_last_ = false;  ///< of any pixel's K nearest
  std::size_t arrived_count_ = 0;
  std::vector<std::uint16_t> pixel_of_ = std::vector<std::uint16_t>(capacity + width);
  std::vector<pixel_fragment> arrived_ = std::vector<pixel_fragment>(capacity + width);
  std::vector<fragment> by_pixel_ = std::vector<fragment>(capacity + width + pixels * K);
  std::vector<std::uint32_t> end_ = std::vector<std::uint32_t>(pixels);       ///< where each pixel's arrivals end
  std::vector<std::uint32_t> count_ = std::vector<std::uint32_t>(pixels);     ///< of its fragments, lost
  std::vector<std::uint32_t> held_ = std::vector<std::uint32_t>(pixels);      ///< of them, kept
  std::vector<std::uint32_t> last_key_ = std::vector<std::uint32_t>(pixels);  ///< depth_key() of the K-th nearest
  std::vector<std::uint32_t> last_id_ = std::vector<std::uint32_t>(pixels);   ///< and its id
  std::vector<pixel_fragment> kept_ = std::vector<pixel_fragment>(pixels * K);
  std::size_t tails_ = 1;     ///< of a pixel
  std::vector<tail> behind_;  ///< pixel after pixel
};

template <std::uint32_t K>
void run_tiles(order_job& work) {
  stopwatch watch;
  const tiles bins(work.from, work.limit, work.drawing_order);
  work.report.bin_seconds = watch.lap();
  tbb::enumerable_thread_specific<tile_worker<K>> workers;
  tbb::parallel_for(0, bins.count(), [&](int t) { workers.local().run(work, bins.rect(t), bins.segments(t)); });
  work.report.build_seconds = watch.lap();
  work.report.bytes = bins.bytes();
  for (const tile_worker<K>& one : workers) {
    work.report.fragments += one.fragments;
    work.report.behind += one.behind;
    work.report.refused += one.refused;
    work.report.longest = std::max(work.report.longest, one.longest);
    work.report.bytes += one.bytes();
  }
}

}  // namespace

void run_k_buffer(order_job& work, std::uint32_t k) {
  with_compiled_k(k, [&](auto constant) { run_tiles<decltype(constant)::value>(work); });
}

}  // namespace pelage::frame
