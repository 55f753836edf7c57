// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/k_select.hpp>
#include <pelage/order/ordered_list.hpp>
#include <pelage/order/unrolled_list.hpp>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <utility>

#include "frame/order/list_memory.hpp"
#include "frame/order/methods.hpp"

/// The methods that keep every fragment in lists.
namespace pelage::frame {
namespace {

/// Pushes every fragment to its pixel's list.
void build_a_buffer(order_job& work, list_memory& memory) {
  stopwatch watch;
  work.for_each_fragment(
      [&](int x, int y, fragment f) { (void)a_buffer::push(memory.lists, memory.list(work, x, y), f); });
  work.report.build_seconds = watch.lap();
  work.report.refused = memory.refused;
}

/// Fragments of one pixel, side by side, to its list.
void push_block(list_memory& memory, std::uint32_t list, std::span<const std::pair<std::uint32_t, fragment>> block) {
  const unrolled_list::node_block nodes = unrolled_list::take(memory.lists, static_cast<std::uint32_t>(block.size()));
  for (std::uint32_t i = 0; i < nodes.size; ++i)
    memory.lists.write_node(nodes.first + i, block[i].second);
  for (std::size_t i = nodes.size; i < block.size(); ++i)
    memory.lists.add_refused(std::memory_order_relaxed);
  unrolled_list::push(memory.lists, list, nodes);
}

/// Pushes what a batch of segments leaves in a pixel to the pixel's list at once.
void build_unrolled_lists(order_job& work, list_memory& memory) {
  using in_list = std::pair<std::uint32_t, fragment>;
  stopwatch watch;
  tbb::enumerable_thread_specific<std::vector<in_list>> per_thread;
  work.for_each_batch([&](std::span<const std::uint32_t> segments) {
    std::vector<in_list>& drawn = per_thread.local();
    drawn.clear();
    work.for_each_fragment_of(segments, [&](int x, int y, fragment f) {
      if (is_fragment(f)) {
        drawn.emplace_back(memory.list(work, x, y), f);
      } else {
        memory.lists.add_refused(std::memory_order_relaxed);
      }
    });
    std::sort(drawn.begin(), drawn.end(), [](const in_list& a, const in_list& b) { return a.first < b.first; });
    for (auto begin = drawn.begin(); begin != drawn.end();) {
      const auto end = std::find_if(begin, drawn.end(), [&](const in_list& one) { return one.first != begin->first; });
      push_block(memory, begin->first, {begin, end});
      begin = end;
    }
  });
  work.report.build_seconds = watch.lap();
  work.report.refused = memory.refused;
}

/// What is done with each pixel's list of all its fragments, in no order: `append(list, all)` reads it, `sort` moves
/// them to the resolver's lists.
template <class Append, class Sort>
void resolve_lists(order_job& work, const list_memory& memory, Append&& append, Sort&& sort) {
  struct scratch {
    std::vector<fragment> all;
    pixel_resolver pixel;
  };
  stopwatch watch;
  tbb::enumerable_thread_specific<scratch> per_thread;
  work.for_each_pixel([&](int x, int y) {
    scratch& mine = per_thread.local();
    mine.all.clear();
    append(memory.list(work, x, y), mine.all);
    sort(mine.all, mine.pixel);
    mine.pixel.finish(work, x, y);
  });
  work.report.resolve_seconds = watch.lap();
}

template <class Sort>
void resolve_a_buffer(order_job& work, const list_memory& memory, Sort&& sort) {
  resolve_lists(
      work, memory, [&](std::uint32_t list, std::vector<fragment>& all) { memory.append(list, all); }, sort);
}

template <std::uint32_t K>
void keep_nearest(const std::vector<fragment>& all, pixel_resolver& pixel) {
  pixel.nearest.resize(K);
  pixel.nearest.resize(k_select<K>(all, std::span<fragment, K>(pixel.nearest)));
  if (pixel.nearest.size() == all.size()) return;
  const fragment last = pixel.nearest.back();
  std::copy_if(all.begin(), all.end(), std::back_inserter(pixel.lost), [&](fragment f) { return before(last, f); });
}

/// A pixel has two lists: the sorted one, and one for the fragments that were too far to enter it.
void build_ordered_lists(order_job& work, list_memory& memory, std::uint32_t k) {
  stopwatch watch;
  const auto pixels = static_cast<std::uint32_t>(work.pixels());
  work.for_each_fragment([&](int x, int y, fragment f) {
    const std::uint32_t list = memory.list(work, x, y);
    const fragment back = ordered_list::insert(memory.lists, list, f, k);
    if (is_fragment(back)) (void)a_buffer::push(memory.lists, pixels + list, back);
  });
  work.report.build_seconds = watch.lap();
  work.report.refused = memory.refused;
}

void resolve_ordered_lists(order_job& work, const list_memory& memory, std::uint32_t k) {
  stopwatch watch;
  const auto pixels = static_cast<std::uint32_t>(work.pixels());
  tbb::enumerable_thread_specific<pixel_resolver> per_thread;
  work.for_each_pixel([&](int x, int y) {
    pixel_resolver& pixel = per_thread.local();
    const std::uint32_t list = memory.list(work, x, y);
    std::uint32_t node = ordered_list::first(memory.lists, list);
    for (; node != no_node(); node = ordered_list::next(memory.lists, node)) {
      (pixel.nearest.size() < k ? pixel.nearest : pixel.lost).push_back(memory.lists.read_node(node));
    }
    memory.append(pixels + list, pixel.lost);
    pixel.finish(work, x, y);
  });
  work.report.resolve_seconds = watch.lap();
}

/// Puts the first `rounds` fragments of the total order first, one a round. [Yang10]
void select(std::vector<fragment>& list, std::size_t rounds) {
  for (std::size_t i = 0; i < rounds; ++i) {
    std::swap(list[i], *std::min_element(list.begin() + static_cast<std::ptrdiff_t>(i), list.end(), before));
  }
}

void selection_sort(std::vector<fragment>& list) {
  select(list, list.size());
}

void library_sort(std::vector<fragment>& list) {
  std::sort(list.begin(), list.end(), before);
}

void run_sort(order_job& work, void (*sort)(std::vector<fragment>&)) {
  list_memory memory(work, 1);
  work.visitor.expect(memory.count);
  build_a_buffer(work, memory);
  resolve_a_buffer(work, memory, [&](std::vector<fragment>& all, pixel_resolver& pixel) {
    sort(all);
    pixel.nearest.swap(all);
  });
}

}  // namespace

void run_a_buffer(order_job& work, std::uint32_t k) {
  list_memory memory(work, 1);
  work.report.behind = memory.beyond(k);
  build_a_buffer(work, memory);
  with_compiled_k(k, [&](auto constant) {
    resolve_a_buffer(work, memory, [](const std::vector<fragment>& all, pixel_resolver& pixel) {
      keep_nearest<decltype(constant)::value>(all, pixel);
    });
  });
}

void run_unrolled_list(order_job& work, std::uint32_t k) {
  list_memory memory(work, 1);
  work.report.behind = memory.beyond(k);
  build_unrolled_lists(work, memory);
  const auto append = [&](std::uint32_t list, std::vector<fragment>& all) {
    std::uint32_t node = unrolled_list::first(memory.lists, list);
    for (; node != no_node(); node = unrolled_list::next(memory.lists, node))
      all.push_back(memory.lists.read_node(node));
  };
  with_compiled_k(k, [&](auto constant) {
    resolve_lists(work, memory, append, [](const std::vector<fragment>& all, pixel_resolver& pixel) {
      keep_nearest<decltype(constant)::value>(all, pixel);
    });
  });
}

void run_ordered_list(order_job& work, std::uint32_t k) {
  list_memory memory(work, 2);
  work.report.behind = memory.beyond(k);
  build_ordered_lists(work, memory, k);
  resolve_ordered_lists(work, memory, k);
}

void run_partial_selection_sort(order_job& work, std::uint32_t k) {
  list_memory memory(work, 1);
  work.report.behind = memory.beyond(k);
  build_a_buffer(work, memory);
  resolve_a_buffer(work, memory, [k](std::vector<fragment>& all, pixel_resolver& pixel) {
    const std::size_t kept = std::min(all.size(), std::size_t{k});
    select(all, kept);
    pixel.lost.assign(all.begin() + static_cast<std::ptrdiff_t>(kept), all.end());
    all.resize(kept);
    pixel.nearest.swap(all);
  });
}

void run_selection_sort(order_job& work) {
  run_sort(work, selection_sort);
}

void run_full_sort(order_job& work) {
  run_sort(work, library_sort);
}

}  // namespace pelage::frame
