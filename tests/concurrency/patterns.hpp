// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include "concurrency/inserts.hpp"
#include "concurrency/report.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <numeric>
#include <string_view>
#include <vector>

namespace pelage::explore {

/// Every way in which a few fragments may compare, up to a renaming of the threads: each thread's ranks in the total
/// order, one thread after the other.
///
/// What an insert does depends on its fragments through before() alone, which is a strict total order whatever ties
/// the depths have. So the permutations of ranks, over the threads! ways to name the threads, are every depth
/// pattern, ties included.
inline std::vector<std::vector<std::size_t>> patterns(std::size_t threads, std::size_t each) {
  std::vector<std::size_t> rank(threads * each);
  std::iota(rank.begin(), rank.end(), std::size_t{0});
  std::vector<std::vector<std::size_t>> all;
  do {
    bool first_name = true;
    for (std::size_t i = each; i < rank.size(); i += each) {
      first_name = first_name && rank[i - each] < rank[i];
    }
    if (first_name) {
      all.push_back(rank);
    }
  } while (std::next_permutation(rank.begin(), rank.end()));
  return all;
}

/// The depth of each rank. Which neighbours tie differs from pattern to pattern, so that every way to tie comes up,
/// in several permutations each: the first is all of one depth, the second has no tie.
inline std::vector<int> depths(std::size_t pattern, std::size_t count) {
  const std::size_t ways = std::size_t{1} << (count - 1);
  const std::size_t untied = pattern == 0 ? 0u : pattern == 1 ? ways - 1u : pattern * 5u % ways;
  std::vector<int> depth_of(count, 0);
  for (std::size_t r = 1; r < count; ++r) {
    depth_of[r] = depth_of[r - 1] + ((untied >> (r - 1) & 1u) != 0u ? 1 : 0);
  }
  return depth_of;
}

/// The fragments of a pattern; ids are ranks, so they rise among ties.
inline inserts fragments(const std::vector<std::size_t>& rank, std::size_t each, const std::vector<int>& depth_of) {
  inserts all(rank.size() / each);
  for (std::size_t i = 0; i < rank.size(); ++i) {
    all[i / each].push_back(fragment{static_cast<float>(depth_of[rank[i]]), static_cast<std::uint32_t>(rank[i])});
  }
  return all;
}

/// Explores a program for every pattern, prints one line for all, and expects no fault. `make` turns inserts into a
/// program_factory. `stride`: takes every so manieth pattern only.
template <class Make>
findings explore_patterns(std::string_view name, std::size_t threads, std::size_t each, Make make,
                          std::size_t stride = 1) {
  const auto all = patterns(threads, each);
  const findings total = report(name, [&] {
    findings sum;
    sum.all = true;
    for (std::size_t p = 0; p < all.size() && sum.fault.empty(); p += stride) {
      const findings f = explore_all(make(fragments(all[p], each, depths(p, threads * each))));
      sum.schedules += f.schedules;
      sum.pruned += f.pruned;
      sum.longest = std::max(sum.longest, f.longest);
      sum.longest_wait = std::max(sum.longest_wait, f.longest_wait);
      sum.all = sum.all && f.all;
      sum.fault = f.fault;
      sum.schedule = f.schedule;
      sum.trace = f.trace;
    }
    return sum;
  });
  std::cout << "  " << (all.size() + stride - 1) / stride << " of " << all.size()
            << " patterns; an operation completes within every " << total.longest_wait << " steps" << std::endl;
  CHECK_MESSAGE(total.fault.empty(), name, ": ", total);
  CHECK(total.all);
  return total;
}

}  // namespace pelage::explore
