// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// atomic_k_buffer and split_k_buffer under every schedule of small cases, and with faults planted.
#include "concurrency/slot_program.hpp"

#include "concurrency/patterns.hpp"
#include "concurrency/report.hpp"
#include "concurrency/slot_faults.hpp"

#include <doctest/doctest.h>

namespace {

using namespace pelage;
using namespace pelage::explore;
using order = std::memory_order;
constexpr order relaxed = std::memory_order_relaxed;

/// Three fragments for two threads and two slots, one tie: each fault shows here, or with a fragment and a slot more.
const inserts small = {{{2.0f, 7u}, {1.0f, 8u}}, {{2.0f, 3u}}};
const inserts four = {{{2.0f, 7u}, {1.0f, 8u}}, {{2.0f, 3u}, {3.0f, 1u}}};

/// An exchange in two steps, each atomic.
struct exchange_in_two_steps : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t compare_exchange(std::uint32_t slot, std::uint64_t expected, std::uint64_t desired, order o) {
    const std::uint64_t held = load(slot, o);
    if (held == expected) {
      cell(slot).store(desired, o);
    }
    return held;
  }
};

/// The exchange is not verified: what came in between is overwritten.
struct exchanges_blindly : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t compare_exchange(std::uint32_t slot, std::uint64_t expected, std::uint64_t desired, order o) {
    (void)cell(slot).exchange(desired, o);
    return expected;
  }
};

/// An exchange that failed is not tried again.
struct exchange_without_retry : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t compare_exchange(std::uint32_t slot, std::uint64_t expected, std::uint64_t desired, order o) {
    (void)watched_slots::compare_exchange(slot, expected, desired, o);
    return expected;
  }
};

/// A slot as it looks to threads that insert, and as it is to who reads in the end.
template <class Look>
struct slots_that_look : watched_slots {
  using watched_slots::watched_slots;
  [[nodiscard]] std::uint64_t load(std::uint32_t slot, order o) const {
    const std::uint64_t held = watched_slots::load(slot, o);
    return world::current().thread() >= 0 ? Look()(slot, size() - 1u, held) : held;
  }
};

/// (1) compares depths alone, so that a tie comes back that should have stayed.
struct last_by_depth_alone {
  std::uint64_t operator()(std::uint32_t slot, std::uint32_t last, std::uint64_t held) const {
    return slot == last ? held & 0xffffffff00000000u : held;
  }
};

/// (2) does not see the first slot, and replaces one that is nearer.
struct first_unseen {
  std::uint64_t operator()(std::uint32_t slot, std::uint32_t, std::uint64_t held) const {
    return slot == 0u ? 0u : held;
  }
};

/// (1) sees an empty slot at all times, as a load that is always stale: correct.
struct last_empty {
  std::uint64_t operator()(std::uint32_t slot, std::uint32_t last, std::uint64_t held) const {
    return slot == last ? pack(no_fragment()) : held;
  }
};

/// Second pass: a slot goes to the id that comes first.
struct ids_by_arrival : watched_depths_and_ids {
  using watched_depths_and_ids::watched_depths_and_ids;
  std::uint32_t fetch_min(std::uint32_t n, std::uint32_t id, order o) {
    if (!is_id(n)) {
      return watched_depths_and_ids::fetch_min(n, id, o);
    }
    std::uint32_t held = no_fragment().id;
    return cell(n).compare_exchange_strong(held, id, o, relaxed) ? held : id;
  }
};

/// A minimum in two steps, in the first pass or in the second one.
template <bool Ids>
struct half_minimum_in_two_steps : watched_depths_and_ids {
  using watched_depths_and_ids::watched_depths_and_ids;
  std::uint32_t fetch_min(std::uint32_t n, std::uint32_t value, order o) {
    if (is_id(n) != Ids) {
      return watched_depths_and_ids::fetch_min(n, value, o);
    }
    const std::uint32_t held = load(n, o);
    cell(n).store(std::min(held, value), o);
    return held;
  }
};

TEST_CASE("atomic_k_buffer holds the K nearest in order and hands the rest back, under every schedule") {
  explore_patterns("atomic_k_buffer<1> 3x2", 3, 2, slot_test<one_pass<1>>());
  explore_patterns("atomic_k_buffer<2> 3x2", 3, 2, slot_test<one_pass<2>>(), 20);
  explore_patterns("atomic_k_buffer<2> 2x3", 2, 3, slot_test<one_pass<2>>());
  explore_patterns("atomic_k_buffer<3> 2x2", 2, 2, slot_test<one_pass<3>>());
  explore_patterns("atomic_k_buffer<4> 2x2 and a reader", 2, 2, slot_test<one_pass<4>>(true));
}

TEST_CASE("atomic_k_buffer does so with a minimum by compare-exchange too, and some insert always completes") {
  const auto f =
      explore_patterns("atomic_k_buffer<2> 2x2, exchanged", 2, 2, slot_test<one_pass<2, watched_exchanged_slots>>());
  // For each thread a load, and a load and an exchange a slot, which are tried again once: when the other's insert has
  // made that slot fall, too.
  CHECK(f.longest_wait <= 2 * (1 + 2 * 2 * 2));
  explore_patterns("atomic_k_buffer<1> 3x1, exchanged", 3, 1, slot_test<one_pass<1, watched_exchanged_slots>>());
}

TEST_CASE("split_k_buffer holds the K nearest in order and hands the rest back, under every schedule") {
  explore_patterns("split_k_buffer<2> 2x2", 2, 2, slot_test<split_slots<2>>());
  explore_patterns("split_k_buffer<3> 2x2 and a reader", 2, 2, slot_test<split_slots<3>>(true));
  explore_patterns("split_k_buffer<2> 3x1", 3, 1, slot_test<split_slots<2>>());
  explore_patterns("split_k_buffer<2> 2x3", 2, 3, slot_test<split_slots<2>>(), 4);
}

template <class Storage, std::uint32_t K = 2u>
void found(std::string_view name, std::string_view as, const inserts& work = small) {
  expect_found("atomic_k_buffer: " + std::string(name), as, slot_test<one_pass<K, Storage>>()(work));
}

template <class Storage, class BetweenPasses = sound_barrier, class BeforeReading = sound_barrier>
void found_in_split_slots(std::string_view name, std::string_view as, bool reads = false) {
  expect_found("split_k_buffer: " + std::string(name), as,
               slot_test<split_slots<2, Storage>, BetweenPasses, BeforeReading>(reads)(small));
}

TEST_CASE("atomic_k_buffer: each fault is found") {
  found<exchange_in_two_steps>("(3) an exchange in two steps", "the slots are not");
  found<exchanges_blindly>("(3) an exchange that is not verified", "the slots are not");
  found<exchange_without_retry>("(3) a lost retry", "the slots are not");
  found<minimum_in_two_steps>("(4) a minimum in two steps", "a fragment is lost", four);
  found<minimum_without_retry>("(4) a lost retry", "the slots are not", four);
  found<hands_back_the_smaller>("(4) hands back the smaller", "a fragment is lost");
  found<slots_that_look<last_by_depth_alone>>("(1) compares depths alone", "the slots are not", four);
  found<refuses_too_early>("(1) looks at the first slot", "the slots are not");
  found<slots_that_look<first_unseen>, 3u>("(2) a slot is not seen", "the slots are not", four);
  const auto reads = [](auto test) { return test(small); };
  expect_found("atomic_k_buffer: (5) no barrier before the reader", "the slots are not",
               reads(slot_test<one_pass<2>, sound_barrier, missing_barrier>(true)));
  expect_found("atomic_k_buffer: (5) the barrier arrives relaxed", "the slots are not",
               reads(slot_test<one_pass<2>, sound_barrier, barrier_arriving_relaxed>(true)));
  expect_found("atomic_k_buffer: (5) the barrier waits relaxed", "the slots are not",
               reads(slot_test<one_pass<2>, sound_barrier, barrier_waiting_relaxed>(true)));
}

TEST_CASE("split_k_buffer: each fault is found") {
  found_in_split_slots<half_minimum_in_two_steps<false>>("(2) a minimum in two steps", "the slots are not");
  found_in_split_slots<half_minimum_in_two_steps<true>>("(4) a minimum in two steps", "the slots are not");
  found_in_split_slots<ids_by_arrival>("(4) ids go by arrival", "the slots are not");
  found_in_split_slots<watched_depths_and_ids, missing_barrier>("(3) no barrier between the passes",
                                                                "the slots are not");
  found_in_split_slots<watched_depths_and_ids, barrier_arriving_relaxed>("(3) that barrier arrives relaxed",
                                                                         "the slots are not");
  found_in_split_slots<watched_depths_and_ids, barrier_waiting_relaxed>("(3) that barrier waits relaxed",
                                                                        "the slots are not");
  found_in_split_slots<watched_depths_and_ids, sound_barrier, missing_barrier>("(5) no barrier before the reader",
                                                                               "the slots are not", true);
}

TEST_CASE("correct variants of the slots are not reported") {
  expect_sound("atomic_k_buffer, all seq_cst", slot_test<one_pass<2, seq_cst_slots>>()(small));
  expect_sound("atomic_k_buffer, (1) always stale", slot_test<one_pass<2, slots_that_look<last_empty>>>()(small));
  expect_sound("atomic_k_buffer, exchanged, and a reader",
               slot_test<one_pass<2, watched_exchanged_slots>>(true)(small));
  expect_sound("split_k_buffer and a reader", slot_test<split_slots<2>>(true)(small));
}

}  // namespace
