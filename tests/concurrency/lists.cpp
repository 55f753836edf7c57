// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// a_buffer and ordered_list under every schedule of small cases.
#include "concurrency/list_program.hpp"
#include "concurrency/report.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace pelage;
using namespace pelage::explore;

/// Six fragments for `threads` threads, by the rank that each has in the total order; the depth of rank r is
/// depth_of[r]. Ranks of equal depth have rising ids.
list_work six(int threads, const std::array<int, 6>& rank, const std::array<int, 6>& depth_of) {
  list_work work;
  work.inserts.resize(static_cast<std::size_t>(threads));
  for (std::size_t i = 0; i < 6; ++i) {
    const auto r = static_cast<std::size_t>(rank[i]);
    work.inserts[i * static_cast<std::size_t>(threads) / 6].push_back(
        fragment{static_cast<float>(depth_of[r]), static_cast<std::uint32_t>(r)});
  }
  return work;
}

/// Every way in which six fragments may compare, up to a renaming of the threads. What an insert does depends on its
/// fragments through before() alone, and that is a strict total order whatever ties the depths have: so the 6!
/// permutations of ranks, over the threads! ways to name the threads, are every depth pattern, ties included.
std::vector<std::array<int, 6>> patterns(int threads) {
  const std::size_t each = 6 / static_cast<std::size_t>(threads);
  std::array<int, 6> rank = {0, 1, 2, 3, 4, 5};
  std::vector<std::array<int, 6>> all;
  do {
    bool first_name = true;
    for (std::size_t i = each; i < 6; i += each) {
      first_name = first_name && rank[i - each] < rank[i];
    }
    if (first_name) {
      all.push_back(rank);
    }
  } while (std::next_permutation(rank.begin(), rank.end()));
  return all;
}

/// The ties of rank r and r + 1 differ from pattern to pattern, so that all 32 ways to tie six ranks come up, each
/// in several permutations; the first runs without any tie, the second with nothing else.
std::array<int, 6> depths(std::size_t pattern) {
  const std::size_t untied = pattern == 0 ? 31u : pattern == 1 ? 0u : pattern * 5u % 32u;
  std::array<int, 6> depth_of{};
  for (std::size_t r = 1; r < 6; ++r) {
    depth_of[r] = depth_of[r - 1] + ((untied >> (r - 1) & 1u) != 0u ? 1 : 0);
  }
  return depth_of;
}

template <class Algorithm>
void explore_patterns(std::string_view name, int threads, pool nodes) {
  const findings total = report(name, [&] {
    findings sum;
    std::size_t pattern = 0;
    for (const auto& rank : patterns(threads)) {
      list_work work = six(threads, rank, depths(pattern++));
      work.nodes = nodes;
      const findings f = explore_all(list_test<Algorithm>(work));
      sum.schedules += f.schedules;
      sum.pruned += f.pruned;
      sum.longest = std::max(sum.longest, f.longest);
      sum.longest_wait = std::max(sum.longest_wait, f.longest_wait);
      if (!f.fault.empty()) {
        sum.fault = f.fault;
        sum.schedule = f.schedule;
        break;
      }
    }
    return sum;
  });
  CHECK_MESSAGE(total.fault.empty(), name, ": ", total.fault, " [", total.schedule, "]");
  // Lock-free: whoever is suspended, so many steps of the others complete an insert. A search over at most five
  // nodes and a publication, for each thread, and once more after each failure that the last completion caused.
  CHECK(total.longest_wait <= threads * 2 * (5 + 5));
  std::cout << "  " << patterns(threads).size() << " patterns; an insert completes within every "
            << total.longest_wait << " steps" << std::endl;
}

TEST_CASE("the patterns are all permutations up to the threads' names, and every tie comes up") {
  CHECK(patterns(3).size() == 120);
  CHECK(patterns(2).size() == 360);
  std::set<std::array<int, 6>> ties;
  for (std::size_t p = 0; p < 120; ++p) {
    ties.insert(depths(p));
  }
  CHECK(ties.size() == 32);
}

TEST_CASE("ordered_list: 3 threads with 2 inserts each end sorted and complete under every schedule") {
  explore_patterns<ordered_inserts>("ordered_list 3x2", 3, pool::apart);
}

TEST_CASE("ordered_list: 2 threads with 3 inserts each end sorted and complete under every schedule") {
  explore_patterns<ordered_inserts>("ordered_list 2x3", 2, pool::shared);
}

TEST_CASE("a_buffer: 3 threads with 2 pushes each keep every fragment under every schedule") {
  list_work work = six(3, {0, 1, 2, 3, 4, 5}, {0, 0, 1, 1, 2, 2});
  work.joined_reader = true;
  work.nodes = pool::apart;
  expect_sound("a_buffer 3x2, joined reader", list_test<unordered_inserts>(work));
}

}  // namespace
