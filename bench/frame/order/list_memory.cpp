// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order/list_memory.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace pelage::frame {

list_memory::list_memory(order_job& work, std::size_t lists_per_pixel) : count(work.pixels(), 0) {
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

std::uint64_t list_memory::beyond(std::uint32_t k) const {
  std::uint64_t sum = 0;
  for (const std::uint32_t n : count)
    sum += n > k ? n - k : 0;
  return sum;
}

}  // namespace pelage::frame
