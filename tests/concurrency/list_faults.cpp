// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// The explorer is tested by what it must find, and by what it must not report.
#include "concurrency/list_faults.hpp"

#include "concurrency/list_program.hpp"
#include "concurrency/report.hpp"

#include <doctest/doctest.h>

namespace {

using namespace pelage;
using namespace pelage::explore;
using namespace pelage::explore::list_variants;

/// Two threads, three fragments, one tie: each fault on the list shows here.
list_work small() {
  list_work work;
  work.inserts = {{{2.0f, 7u}, {1.0f, 8u}}, {{2.0f, 3u}}};
  return work;
}

list_work small_with_reader() {
  list_work work = small();
  work.readers = 1;
  work.nodes = pool::apart;
  return work;
}

list_work small_then_reader() {
  list_work work = small();
  work.joined_reader = true;
  return work;
}

list_work full_pool() {
  list_work work = small();
  work.inserts = {{{1.0f, 0u}, {2.0f, 1u}, {3.0f, 2u}, {4.0f, 3u}}, {{5.0f, 4u}, {6.0f, 5u}}};
  work.capacity = 2;
  return work;
}

template <class Storage>
void found(std::string_view name, std::string_view as, const list_work& work, int patience = default_patience) {
  expect_found(name, as, list_test<ordered_inserts, Storage>(work), patience);
}

template <class Storage>
void found_in_a_buffer(std::string_view name, std::string_view as, const list_work& work) {
  expect_found("a_buffer: " + std::string(name), as, list_test<unordered_inserts, Storage>(work));
}

template <class Storage>
void found_in_unrolled_list(std::string_view name, std::string_view as, list_work work, std::uint32_t block = 2) {
  work.block = block;
  expect_found("unrolled_list: " + std::string(name), as, list_test<block_inserts, Storage>(work));
}

template <class Storage>
void sound(std::string_view name, const list_work& work) {
  expect_sound(name, list_test<ordered_inserts, Storage>(work));
}

TEST_CASE("ordered_list: each memory order that is weakened is found, by the race that it allows") {
  found<insert_loads_relaxed>("(1) an inserter's load relaxed", "race on node", small());
  found<publishes_relaxed>("(3) the publication relaxed", "race on node", small());
  found<publishes_acquire>("(3) the publication acquire, not release", "race on node", small());
  found<reader_loads_relaxed>("(4) a reader's load relaxed", "race on node", small_with_reader());
}

TEST_CASE("ordered_list: each fence that is left out or misplaced is found") {
  found<no_insert_fence>("no acquire fence behind an inserter's load", "race on node", small());
  found<no_reader_fence>("no acquire fence behind a reader's load", "race on node", small_with_reader());
  found<no_publish_fence>("no release fence before the publication", "race on node", small());
  found<late_publish_fence>("the release fence behind the publication", "race on node", small());
}

TEST_CASE("ordered_list: each step of the algorithm that is left out is found") {
  found<no_verification>("the successor is not verified", "a fragment is lost", small());
  found<verifies_then_stores>("verification and store in two steps", "a fragment is lost", small());
  found<no_retry>("a lost retry", "a fragment is lost", small());
  found<keeps_old_successor>("(2) the own link keeps the first successor", "a fragment is lost", small());
  found<links_after_publishing>("(2) the own link is stored after (3)", "a fragment is lost", small());
  found<ties_by_slot>("ties go by slot", "the list is out of order", small());
  found<locked>("a lock around the publication", "no progress", small(), 100);
}

TEST_CASE("the pool: each bound and each atomic addition that is left out is found") {
  found<unbounded_counter>("the pool's counter has no bound", "the pool's counter goes more", full_pool());
  found<overdrawn_pool>("no look at what the counter gave", "race on node", full_pool());
  found<counter_in_two_steps>("the pool's counter in two steps", "race on node", small());
  found<refusals_in_two_steps>("refusals counted in two steps", "the count of refused", full_pool());
}

TEST_CASE("a_buffer: each fault is found") {
  found_in_a_buffer<head_in_two_steps>("(1) the head in two steps", "a fragment is lost", small());
  found_in_a_buffer<unlinked>("(2) the own link left out", "a fragment is lost", small());
  found_in_a_buffer<with_barrier<missing_barrier>>("no barrier before the reader", "race on node", small_then_reader());
  found_in_a_buffer<with_barrier<barrier_arriving_relaxed>>("the barrier arrives relaxed", "race on node",
                                                            small_then_reader());
  found_in_a_buffer<with_barrier<barrier_waiting_relaxed>>("the barrier waits relaxed", "race on node",
                                                           small_then_reader());
}

TEST_CASE("unrolled_list: each fault is found") {
  found_in_unrolled_list<unbounded_counter>("(1) the pool's counter has no bound", "the pool's counter goes more",
                                            full_pool(), 1);
  found_in_unrolled_list<counter_in_two_steps>("(2) the pool's counter in two steps", "race on node", small());
  found_in_unrolled_list<head_in_two_steps>("(3) the head in two steps", "a fragment is lost", small());
  found_in_unrolled_list<unlinked>("(4) the last node's link left out", "a link leads out of the pool", small());
  found_in_unrolled_list<with_barrier<missing_barrier>>("no barrier before the reader", "race on node",
                                                        small_then_reader());
  found_in_unrolled_list<with_barrier<barrier_arriving_relaxed>>("the barrier arrives relaxed", "race on node",
                                                                 small_then_reader());
  found_in_unrolled_list<with_barrier<barrier_waiting_relaxed>>("the barrier waits relaxed", "race on node",
                                                                small_then_reader());
}

TEST_CASE("correct variants are not reported") {
  sound<watched_lists>("the library's orders, with a reader", small_with_reader());
  sound<publishes_acq_rel>("(3) acq_rel", small_with_reader());
  sound<all_seq_cst>("all seq_cst", small());
  sound<fences>("fences in place of orders", small_with_reader());
  sound<watched_lists>("a pool that is full", full_pool());
  sound<ties_by_slot>("ties by slot, where no depths tie", [] {
    list_work work = small();
    work.inserts[1][0].depth = 3.0f;
    return work;
  }());
  expect_sound("a_buffer with a counted barrier",
               list_test<unordered_inserts, with_barrier<sound_barrier>>(small_then_reader()));
  expect_sound("a_buffer, a pool that is full", list_test<unordered_inserts>(full_pool()));
  list_work blocks = small_then_reader();
  blocks.block = 2;
  expect_sound("unrolled_list with a counted barrier", list_test<block_inserts, with_barrier<sound_barrier>>(blocks));
  blocks = full_pool();
  blocks.block = 3;
  expect_sound("unrolled_list, a pool that is full", list_test<block_inserts>(blocks));
}

}  // namespace
