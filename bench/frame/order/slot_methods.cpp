// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/split_k_buffer.hpp>
#include <tbb/enumerable_thread_specific.h>

#include <stdexcept>

#include "frame/order/list_memory.hpp"
#include "frame/order/methods.hpp"

/// The methods that keep K fragments a pixel in slots, built by atomic minima. The list of a pixel takes what falls
/// out of its slots.
namespace pelage::frame {
namespace {

void check_slots(const order_job& work, std::uint32_t k) {
  if (work.pixels() > 0xffffffffU / k) {
    throw std::runtime_error("the picture has more slots than can be numbered; use --order k_buffer");
  }
}

/// Inserts every fragment: `insert(pixel, fragment)` gives what falls out.
template <class Insert>
void insert_all(const order_job& work, list_memory& memory, Insert&& insert) {
  work.for_each_fragment([&](int x, int y, fragment f) {
    const std::uint32_t pixel = memory.list(work, x, y);
    const fragment lost = insert(pixel, f);
    if (is_fragment(lost)) (void)a_buffer::push(memory.lists, pixel, lost);
  });
}

/// Reads every slot: `at(pixel, i)` gives the i-th nearest fragment.
template <class At>
void resolve_slots(order_job& work, const list_memory& memory, std::uint32_t k, At&& at) {
  work.report.refused = memory.refused;
  stopwatch watch;
  tbb::enumerable_thread_specific<pixel_resolver> per_thread;
  work.for_each_pixel([&](int x, int y) {
    pixel_resolver& resolver = per_thread.local();
    const std::uint32_t pixel = memory.list(work, x, y);
    for (std::uint32_t i = 0; i < k && is_fragment(at(pixel, i)); ++i)
      resolver.nearest.push_back(at(pixel, i));
    memory.append(pixel, resolver.lost);
    resolver.finish(work, x, y);
  });
  work.report.resolve_seconds = watch.lap();
}

template <std::uint32_t K>
void run_atomic(order_job& work, list_memory& memory) {
  std::vector<std::uint64_t> slots(work.pixels() * K, pack(no_fragment()));
  atomic_cells<std::uint64_t> nearest{slots};
  work.report.bytes += slots.size() * sizeof(std::uint64_t);
  stopwatch watch;
  insert_all(work, memory,
             [&](std::uint32_t pixel, fragment f) { return atomic_k_buffer::insert<K>(nearest, pixel, f); });
  work.report.build_seconds = watch.lap();
  resolve_slots(work, memory, K,
                [&](std::uint32_t pixel, std::uint32_t i) { return atomic_k_buffer::at<K>(nearest, pixel, i); });
}

/// Both passes' ends are barriers, as parallel_for() returns when all is done.
template <std::uint32_t K>
void run_split(order_job& work, list_memory& memory) {
  std::vector<std::uint32_t> cells(work.pixels() * 2U * K, 0xffffffffU);
  atomic_cells<std::uint32_t> nearest{cells};
  work.report.bytes += cells.size() * sizeof(std::uint32_t);
  stopwatch watch;
  work.for_each_fragment(
      [&](int x, int y, fragment f) { split_k_buffer::offer_depth<K>(nearest, memory.list(work, x, y), f); });
  insert_all(work, memory,
             [&](std::uint32_t pixel, fragment f) { return split_k_buffer::insert<K>(nearest, pixel, f); });
  work.report.build_seconds = watch.lap();
  resolve_slots(work, memory, K,
                [&](std::uint32_t pixel, std::uint32_t i) { return split_k_buffer::at<K>(nearest, pixel, i); });
}

}  // namespace

void run_atomic_k_buffer(order_job& work, std::uint32_t k) {
  check_slots(work, k);
  list_memory memory(work, 1);
  work.report.behind = memory.beyond(k);
  with_compiled_k(k, [&](auto constant) { run_atomic<decltype(constant)::value>(work, memory); });
}

void run_split_k_buffer(order_job& work, std::uint32_t k) {
  check_slots(work, 2U * k);
  list_memory memory(work, 1);
  work.report.behind = memory.beyond(k);
  with_compiled_k(k, [&](auto constant) { run_split<decltype(constant)::value>(work, memory); });
}

}  // namespace pelage::frame
