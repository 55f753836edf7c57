// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/atomic_cells.hpp>
#include <pelage/order/packed_fragment.hpp>

#include "order/oracle.hpp"

#include <algorithm>
#include <barrier>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

namespace pelage::test {

/// Calls work(t) for t in [0, threads), each in a thread of its own, all at once.
template <class Work>
void in_threads(std::uint32_t threads, Work work) {
  std::barrier start(static_cast<std::ptrdiff_t>(threads));
  std::vector<std::jthread> running;
  for (std::uint32_t t = 0u; t < threads; ++t) {
    running.emplace_back([&, t] {
      start.arrive_and_wait();
      work(t);
    });
  }
}

/// A few pixels of K slots, the one under test between two that nobody touches.
template <std::uint32_t K>
struct packed_pixels {
  std::vector<std::uint64_t> memory = std::vector<std::uint64_t>(3u * K, pack(no_fragment()));
  atomic_cells<std::uint64_t> storage{memory};
};

template <std::uint32_t K>
struct split_pixels {
  std::vector<std::uint32_t> memory = std::vector<std::uint32_t>(6u * K, 0xffffffffu);
  atomic_cells<std::uint32_t> storage{memory};
};

/// What is in the slots of the middle pixel, and what came back from it.
struct outcome {
  std::vector<fragment> slots;
  std::vector<fragment> back;
};

/// Offers fragments to the middle pixel, dealt out to threads in turn, and joins them. `offer` returns what fell out.
template <class Storage, class Offer>
std::vector<fragment> offer_all(Storage& storage, const std::vector<fragment>& all, std::uint32_t threads,
                                Offer offer) {
  std::vector<std::vector<fragment>> back(threads);
  in_threads(threads, [&](std::uint32_t t) {
    for (std::size_t i = t; i < all.size(); i += threads) {
      const fragment lost = offer(storage, all[i]);
      if (bits(lost) != bits(no_fragment())) {
        back[t].push_back(lost);
      }
    }
  });
  std::vector<fragment> joined_back;
  for (const auto& of_one : back) {
    joined_back = joined(joined_back, of_one);
  }
  return joined_back;
}

/// -0 comes back as +0, since both have one key.
inline std::vector<fragment> without_negative_zero(std::vector<fragment> all) {
  for (fragment& f : all) {
    f.depth = f.depth == 0.0f ? 0.0f : f.depth;
  }
  return all;
}

/// True if the slots are the K nearest in order, and what came back is the rest of what may be held, and all that may
/// not, each once.
inline bool is_k_nearest(const outcome& seen, const std::vector<fragment>& offered) {
  const std::size_t k = seen.slots.size();
  const std::vector<fragment> all = without_negative_zero(in_order(offered));
  std::vector<std::uint64_t> expected_back;
  for (std::size_t i = k; i < all.size(); ++i) {
    expected_back.push_back(bits(all[i]));
  }
  for (const fragment f : offered) {
    if (refusable(f) && bits(f) != bits(no_fragment())) {  // none comes back as none
      expected_back.push_back(bits(f));
    }
  }
  std::vector<std::uint64_t> back = bits(seen.back);
  std::sort(expected_back.begin(), expected_back.end());
  std::sort(back.begin(), back.end());
  return back == expected_back && bits(seen.slots) == bits(without_negative_zero(in_order(offered, 0, k)));
}

}  // namespace pelage::test
