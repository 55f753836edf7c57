// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// a_buffer, unrolled_list and ordered_list under every schedule of small cases.
#include "concurrency/list_program.hpp"
#include "concurrency/patterns.hpp"
#include "concurrency/report.hpp"

#include <doctest/doctest.h>

#include <set>
#include <vector>

namespace {

using namespace pelage;
using namespace pelage::explore;

auto make_list(pool nodes, std::uint32_t readers, bool walks) {
  return [=](const inserts& all) {
    list_work work;
    work.inserts = all;
    work.nodes = nodes;
    work.readers = readers;
    work.walks = walks;
    return list_test<ordered_inserts>(work);
  };
}

TEST_CASE("the patterns are all permutations up to the threads' names, and every tie comes up") {
  CHECK(patterns(3, 2).size() == 120);
  CHECK(patterns(2, 3).size() == 360);
  std::set<std::vector<int>> ties;
  for (std::size_t p = 0; p < 120; ++p) {
    ties.insert(depths(p, 6));
  }
  CHECK(ties.size() == 32);
}

TEST_CASE("ordered_list: 3 threads with 2 inserts each end sorted and complete, and some insert always completes") {
  const findings f = explore_patterns("ordered_list 3x2", 3, 2, make_list(pool::apart, 0, false));
  // Each thread passes at most five nodes and needs two steps at each place it stops; a completed insert sends each
  // of the others back at most once.
  CHECK(f.longest_wait <= 3 * (5 + 2 * 2));
}

TEST_CASE("ordered_list: 2 threads with 3 inserts each end sorted and complete, and some insert always completes") {
  const findings f = explore_patterns("ordered_list 2x3", 2, 3, make_list(pool::apart, 0, false));
  CHECK(f.longest_wait <= 2 * (5 + 2 * 2));
}

TEST_CASE("ordered_list: with one counter for all nodes it is the same, whoever asks it first") {
  explore_patterns("ordered_list 2x2, one pool", 2, 2, make_list(pool::shared, 0, false));
  explore_patterns("ordered_list 3x1, one pool", 3, 1, make_list(pool::shared, 0, false));
  const inserts tied = {{{1.0f, 5u}, {2.0f, 0u}, {1.0f, 2u}}, {{2.0f, 1u}, {1.0f, 3u}, {1.0f, 4u}}};
  expect_sound("ordered_list 2x3, one pool, ties", make_list(pool::shared, 0, false)(tied));
}

TEST_CASE("ordered_list: a reader that walks meanwhile sees a sorted list of whole nodes, and never less again") {
  explore_patterns("ordered_list 2x2 and a reader", 2, 2, make_list(pool::apart, 1, false));
}

TEST_CASE("ordered_list: a thread that walks after its inserts sees them all") {
  explore_patterns("ordered_list 2x2, each walks", 2, 2, make_list(pool::apart, 0, true));
  explore_patterns("ordered_list 3x1, each walks", 3, 1, make_list(pool::shared, 0, true));
}

TEST_CASE("ordered_list: with a limit, the nearest are there whatever came back") {
  for (const std::uint32_t limit : {1u, 2u}) {
    explore_patterns("ordered_list 2x2, limit " + std::to_string(limit), 2, 2, [limit](const inserts& all) {
      list_work work;
      work.inserts = all;
      work.limit = limit;
      return list_test<ordered_inserts>(work);
    });
  }
}

TEST_CASE("ordered_list: a pool that is too small keeps the list whole and gives back the rest") {
  for (const std::uint32_t capacity : {0u, 1u, 3u}) {
    explore_patterns("ordered_list 2x2, pool of " + std::to_string(capacity), 2, 2, [capacity](const inserts& all) {
      list_work work;
      work.inserts = all;
      work.capacity = capacity;
      return list_test<ordered_inserts>(work);
    });
  }
}

template <class Algorithm>
auto make_unsorted_list(pool nodes, std::uint32_t block = 1) {
  return [=](const inserts& all) {
    list_work work;
    work.inserts = all;
    work.nodes = nodes;
    work.joined_reader = true;
    work.block = block;
    return list_test<Algorithm>(work);
  };
}

TEST_CASE("a_buffer: every fragment is there for a reader behind the barrier") {
  explore_patterns("a_buffer 3x2", 3, 2, make_unsorted_list<unordered_inserts>(pool::apart));
  explore_patterns("a_buffer 2x3", 2, 3, make_unsorted_list<unordered_inserts>(pool::apart));
  explore_patterns("a_buffer 2x2, one pool", 2, 2, make_unsorted_list<unordered_inserts>(pool::shared));
}

TEST_CASE("unrolled_list: every fragment is there for a reader behind the barrier, whatever the blocks") {
  explore_patterns("unrolled_list 3x2, blocks of 2", 3, 2, make_unsorted_list<block_inserts>(pool::apart, 2));
  explore_patterns("unrolled_list 2x3, blocks of 2 and 1", 2, 3, make_unsorted_list<block_inserts>(pool::apart, 2));
  explore_patterns("unrolled_list 2x2, one pool", 2, 2, make_unsorted_list<block_inserts>(pool::shared, 1));
  explore_patterns("unrolled_list 3x2, blocks of 2, one pool", 3, 2,
                   make_unsorted_list<block_inserts>(pool::shared, 2));
}

}  // namespace
