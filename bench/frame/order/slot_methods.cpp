// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/split_k_buffer.hpp>
#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <stdexcept>

#include "frame/order/list_memory.hpp"
#include "frame/order/methods.hpp"

/// The methods that keep K fragments a pixel in slots, built by atomics. The list of a pixel takes what falls
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

/// Reads every slot: `load(pixel)` gives the K nearest in order.
template <class Load>
void resolve_slots(order_job& work, const list_memory& memory, Load&& load) {
  work.report.refused = memory.refused;
  stopwatch watch;
  tbb::enumerable_thread_specific<pixel_resolver> per_thread;
  work.for_each_pixel([&](int x, int y) {
    pixel_resolver& resolver = per_thread.local();
    const std::uint32_t pixel = memory.list(work, x, y);
    for (const fragment f : load(pixel))
      if (is_fragment(f)) resolver.nearest.push_back(f);
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
  resolve_slots(work, memory, [&](std::uint32_t pixel) { return atomic_k_buffer::load<K>(nearest, pixel); });
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
  resolve_slots(work, memory, [&](std::uint32_t pixel) {
    std::array<fragment, K> slots;
    for (std::uint32_t i = 0; i < K; ++i)
      slots[i] = split_k_buffer::at<K>(nearest, pixel, i);
    return slots;
  });
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
