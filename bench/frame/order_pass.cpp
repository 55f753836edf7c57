// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order_pass.hpp"

#include <pelage/order/a_buffer.hpp>
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/ordered_list.hpp>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>

#include "frame/tiles.hpp"

namespace pelage::frame {
namespace {

class stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What all methods share: where the fragments come from and where they go.
struct job {
  const raster& from;
  std::span<const float> limit;
  std::span<const std::uint32_t> drawing_order;
  pixel_visitor& visitor;
  order_report report;

  [[nodiscard]] std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(from.from().width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] std::size_t pixels() const { return pixel(0, from.from().height); }

  template <class Visit>
  void for_each_visible(std::uint32_t segment, const pixel_rect& clip, Visit&& visit) const {
    from.for_each(segment, clip, [&](int x, int y, const touch& t) {
      if (limit.empty() || !(t.depth >= limit[pixel(x, y)])) visit(x, y, t);
    });
  }

  /// All fragments in no order, from all threads.
  template <class Visit>
  void for_each_fragment(Visit&& visit) const {
    const tbb::blocked_range<std::uint32_t> all(0, from.fibres().segment_count(), 4096);
    const pixel_rect whole{0, 0, from.from().width, from.from().height};
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::uint32_t>& some) {
      for (std::uint32_t i = some.begin(); i < some.end(); ++i) {
        const std::uint32_t segment = drawing_order.empty() ? i : drawing_order[i];
        for_each_visible(segment, whole, [&](int x, int y, const touch& t) {
          visit(x, y, fragment{t.depth, segment});
        });
      }
    });
  }

  template <class Visit>
  void for_each_pixel(Visit&& visit) const {
    tbb::parallel_for(0, from.from().height, [&](int y) {
      for (int x = 0; x < from.from().width; ++x)
        visit(x, y);
    });
  }

  void lose(int x, int y, fragment lost, tail& behind) const {
    visitor.lose(x, y, lost, from.at(lost.id, x, y), behind);
  }
};

// k_buffer: one thread owns a tile and keeps its buffers in cache. ------------------------------------------

template <std::uint32_t K>
struct tile_buffers {
  static constexpr std::size_t pixels = static_cast<std::size_t>(tiles::side) * tiles::side;
  std::vector<k_buffer<K>> nearest = std::vector<k_buffer<K>>(pixels);
  std::vector<tail> behind = std::vector<tail>(pixels);
  std::vector<std::uint32_t> count = std::vector<std::uint32_t>(pixels);
  std::uint64_t fragments = 0;
  std::uint64_t refused = 0;
  std::uint32_t longest = 0;

  static constexpr std::uint64_t bytes = pixels * (sizeof(k_buffer<K>) + sizeof(tail) + sizeof(std::uint32_t));

  void draw(const job& work, const pixel_rect& rect, std::span<const std::uint32_t> segments) {
    std::fill(nearest.begin(), nearest.end(), k_buffer<K>::empty());
    std::fill(behind.begin(), behind.end(), empty_tail());
    std::fill(count.begin(), count.end(), 0);
    for (const std::uint32_t segment : segments) {
      work.for_each_visible(segment, rect, [&](int x, int y, const touch& t) {
        const std::size_t p = static_cast<std::size_t>((y - rect.y0) * tiles::side + (x - rect.x0));
        ++count[p];
        const fragment lost = nearest[p].insert(fragment{t.depth, segment});
        if (lost.id == segment && is_fragment(lost)) {
          work.visitor.lose(x, y, lost, t, behind[p]);
        } else if (is_fragment(lost)) {
          work.lose(x, y, lost, behind[p]);
        } else if (lost.id != no_fragment().id) {
          ++refused;
        }
      });
    }
  }

  void finish(const job& work, const pixel_rect& rect) {
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        const std::size_t p = static_cast<std::size_t>((y - rect.y0) * tiles::side + (x - rect.x0));
        nearest[p].sort();
        fragments += count[p];
        longest = std::max(longest, count[p]);
        work.visitor.finish(x, y, std::span<const fragment>(nearest[p].slot).first(nearest[p].size()), behind[p]);
      }
    }
  }
};

template <std::uint32_t K>
void run_k_buffer(job& work) {
  stopwatch watch;
  const tiles bins(work.from, work.drawing_order);
  work.report.bin_seconds = watch.lap();
  tbb::enumerable_thread_specific<tile_buffers<K>> scratch;
  tbb::parallel_for(0, bins.count(), [&](int t) {
    tile_buffers<K>& mine = scratch.local();
    mine.draw(work, bins.rect(t), bins.segments(t));
    mine.finish(work, bins.rect(t));
  });
  work.report.build_seconds = watch.lap();
  for (const tile_buffers<K>& one : scratch) {
    work.report.fragments += one.fragments;
    work.report.refused += one.refused;
    work.report.longest = std::max(work.report.longest, one.longest);
  }
  work.report.bytes = bins.bytes() + scratch.size() * tile_buffers<K>::bytes;
}

// The lists: all threads push to all pixels at once. --------------------------------------------------------

/// Memory for lists whose nodes have been counted before, so that the pool is never full.
struct list_memory {
  std::vector<std::uint32_t> count;  ///< fragments a pixel
  std::vector<std::uint32_t> links;
  std::vector<fragment> nodes;
  std::uint32_t taken = 0;
  std::uint32_t refused = 0;
  atomic_list_storage lists{};

  list_memory(job& work, std::size_t lists_per_pixel) : count(work.pixels(), 0) {
    stopwatch watch;
    work.for_each_fragment([&](int x, int y, fragment) {
      std::atomic_ref(count[work.pixel(x, y)]).fetch_add(1, std::memory_order_relaxed);
    });
    for (const std::uint32_t n : count) {
      work.report.fragments += n;
      work.report.longest = std::max(work.report.longest, n);
    }
    if (lists_per_pixel * work.pixels() + work.report.fragments > 0xff000000U) {  // list_storage's bound
      throw std::runtime_error("the frame has more fragments than lists can number; use --order k_buffer");
    }
    nodes.resize(static_cast<std::size_t>(work.report.fragments));
    links.resize(lists_per_pixel * work.pixels() + nodes.size());
    lists = atomic_list_storage{links, nodes, &taken, &refused};
    lists.clear();
    work.report.bytes = (links.size() + count.size()) * sizeof(std::uint32_t) + nodes.size() * sizeof(fragment);
    work.report.bin_seconds = watch.lap();
  }

  [[nodiscard]] std::uint32_t list(const job& work, int x, int y) const {
    return static_cast<std::uint32_t>(work.pixel(x, y));
  }

  /// The fragments of a list that a_buffer::push() built.
  template <class Visit>
  void for_each(std::uint32_t list, Visit&& visit) const {
    for (std::uint32_t node = a_buffer::first(lists, list); node != no_node(); node = a_buffer::next(lists, node)) {
      visit(lists.read_node(node));
    }
  }
};

/// Pushes every fragment to its pixel's list.
void build_a_buffer(job& work, list_memory& memory) {
  stopwatch watch;
  work.for_each_fragment(
      [&](int x, int y, fragment f) { (void)a_buffer::push(memory.lists, memory.list(work, x, y), f); });
  work.report.build_seconds = watch.lap();
  work.report.refused = memory.refused;
}

template <std::uint32_t K>
void run_a_buffer(job& work) {
  list_memory memory(work, 1);
  build_a_buffer(work, memory);
  stopwatch watch;
  work.for_each_pixel([&](int x, int y) {
    k_buffer<K> nearest = k_buffer<K>::empty();
    tail behind = empty_tail();
    memory.for_each(memory.list(work, x, y), [&](fragment f) {
      const fragment lost = nearest.insert(f);
      if (is_fragment(lost)) work.lose(x, y, lost, behind);
    });
    nearest.sort();
    work.visitor.finish(x, y, std::span<const fragment>(nearest.slot).first(nearest.size()), behind);
  });
  work.report.resolve_seconds = watch.lap();
}

/// A pixel has two lists: the sorted one, and one for the fragments that were too far to enter it.
template <std::uint32_t K>
void run_ordered_list(job& work) {
  list_memory memory(work, 2);
  const auto too_far = [&](std::uint32_t list) { return static_cast<std::uint32_t>(work.pixels()) + list; };
  stopwatch watch;
  work.for_each_fragment([&](int x, int y, fragment f) {
    const std::uint32_t list = memory.list(work, x, y);
    const fragment back = ordered_list::insert(memory.lists, list, f, K);
    if (is_fragment(back)) (void)a_buffer::push(memory.lists, too_far(list), back);
  });
  work.report.build_seconds = watch.lap();
  work.report.refused = memory.refused;
  work.for_each_pixel([&](int x, int y) {
    std::array<fragment, K> nearest{};
    std::size_t held = 0;
    tail behind = empty_tail();
    std::uint32_t node = ordered_list::first(memory.lists, memory.list(work, x, y));
    for (; node != no_node() && held < K; node = ordered_list::next(memory.lists, node)) {
      nearest[held++] = memory.lists.read_node(node);
    }
    for (; node != no_node(); node = ordered_list::next(memory.lists, node)) {
      work.lose(x, y, memory.lists.read_node(node), behind);
    }
    memory.for_each(too_far(memory.list(work, x, y)), [&](fragment f) { work.lose(x, y, f, behind); });
    work.visitor.finish(x, y, std::span<const fragment>(nearest).first(held), behind);
  });
  work.report.resolve_seconds = watch.lap();
}

/// The list of a pixel takes what falls out of its slots.
template <std::uint32_t K>
void run_atomic_k_buffer(job& work) {
  if (work.pixels() > 0xffffffffU / K) {
    throw std::runtime_error("the picture has more slots than can be numbered; use --order k_buffer");
  }
  list_memory memory(work, 1);
  std::vector<std::uint64_t> slots(work.pixels() * K);
  atomic_slot_storage nearest{slots};
  nearest.clear();
  work.report.bytes += slots.size() * sizeof(std::uint64_t);
  stopwatch watch;
  work.for_each_fragment([&](int x, int y, fragment f) {
    const std::uint32_t pixel = memory.list(work, x, y);
    const fragment lost = atomic_k_buffer::insert<K>(nearest, pixel, f);
    if (is_fragment(lost)) (void)a_buffer::push(memory.lists, pixel, lost);
  });
  work.report.build_seconds = watch.lap();
  work.report.refused = memory.refused;
  work.for_each_pixel([&](int x, int y) {
    const std::uint32_t pixel = memory.list(work, x, y);
    std::array<fragment, K> sorted{};
    std::uint32_t held = 0;
    for (; held < K; ++held) {
      sorted[held] = atomic_k_buffer::at<K>(nearest, pixel, held);
      if (!is_fragment(sorted[held])) break;
    }
    tail behind = empty_tail();
    memory.for_each(pixel, [&](fragment f) { work.lose(x, y, f, behind); });
    work.visitor.finish(x, y, std::span<const fragment>(sorted).first(held), behind);
  });
  work.report.resolve_seconds = watch.lap();
}

void selection_sort(std::vector<fragment>& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::swap(list[i], *std::min_element(list.begin() + static_cast<std::ptrdiff_t>(i), list.end(), before));
  }
}

void library_sort(std::vector<fragment>& list) {
  std::sort(list.begin(), list.end(), before);
}

void run_sort(job& work, void (*sort)(std::vector<fragment>&)) {
  list_memory memory(work, 1);
  work.visitor.expect(memory.count);
  build_a_buffer(work, memory);
  stopwatch watch;
  tbb::enumerable_thread_specific<std::vector<fragment>> scratch;
  work.for_each_pixel([&](int x, int y) {
    std::vector<fragment>& all = scratch.local();
    all.clear();
    memory.for_each(memory.list(work, x, y), [&](fragment f) { all.push_back(f); });
    sort(all);
    work.visitor.finish(x, y, all, empty_tail());
  });
  work.report.resolve_seconds = watch.lap();
}

template <std::uint32_t K>
void run_with_k(job& work, order_method method) {
  switch (method) {
    case order_method::k_buffer:
      return run_k_buffer<K>(work);
    case order_method::a_buffer:
      return run_a_buffer<K>(work);
    case order_method::ordered_list:
      return run_ordered_list<K>(work);
    case order_method::atomic_k_buffer:
      return run_atomic_k_buffer<K>(work);
    case order_method::selection_sort:
      return run_sort(work, selection_sort);
    case order_method::full_sort:
      return run_sort(work, library_sort);
  }
}

}  // namespace

order_report run_order_pass(const raster& from, std::span<const float> limit, const order_options& options,
                            pixel_visitor& visitor) {
  job work{from, limit, options.drawing_order, visitor, {}};
  switch (options.k) {
    case 1:
      run_with_k<1>(work, options.method);
      break;
    case 2:
      run_with_k<2>(work, options.method);
      break;
    case 4:
      run_with_k<4>(work, options.method);
      break;
    case 8:
      run_with_k<8>(work, options.method);
      break;
    case 16:
      run_with_k<16>(work, options.method);
      break;
    case 32:
      run_with_k<32>(work, options.method);
      break;
    case 64:
      run_with_k<64>(work, options.method);
      break;
    default:
      throw std::invalid_argument("k must be one of 1, 2, 4, 8, 16, 32, 64");
  }
  return work.report;
}

}  // namespace pelage::frame
