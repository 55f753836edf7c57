// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// cascade_k_buffer under every schedule of small cases, and with faults planted.
#include "concurrency/slot_program.hpp"

#include "concurrency/patterns.hpp"
#include "concurrency/report.hpp"
#include "concurrency/slot_faults.hpp"

#include <doctest/doctest.h>

#include <limits>

namespace {

using namespace pelage;
using namespace pelage::explore;
using order = std::memory_order;

/// Three fragments for two threads and two slots, one tie: each fault shows here.
const inserts small = {{{2.0f, 7u}, {1.0f, 8u}}, {{2.0f, 3u}}};

/// The exchange is not verified: what came in between is overwritten.
struct exchanges_blindly : watched_slots {
  using watched_slots::watched_slots;
  std::uint64_t fetch_min(std::uint32_t slot, std::uint64_t value, order o) {
    const std::uint64_t held = load(slot, o);
    return value < held ? cell(slot).exchange(value, o) : held;
  }
};

/// (1) and (2) compare depths alone, so that a tie passes over a slot that it should have taken.
struct looks_at_depth_alone : watched_slots {
  using watched_slots::watched_slots;
  [[nodiscard]] std::uint64_t load(std::uint32_t slot, order o) const {
    return watched_slots::load(slot, o) & 0xffffffff00000000u;
  }
};

/// No value is passed over unseen: a correct variant, as loads that were always stale would make it.
struct passes_nothing_over : watched_slots {
  using watched_slots::watched_slots;
  [[nodiscard]] std::uint64_t load(std::uint32_t slot, order o) const {
    return world::current().thread() >= 0 ? std::numeric_limits<std::uint64_t>::max() : watched_slots::load(slot, o);
  }
};

TEST_CASE("cascade_k_buffer holds the K nearest in order and hands the rest back, under every schedule") {
  explore_patterns("cascade_k_buffer<1> 3x2", 3, 2, slot_test<cascade<1>>());
  explore_patterns("cascade_k_buffer<2> 3x2", 3, 2, slot_test<cascade<2>>(), 40);
  explore_patterns("cascade_k_buffer<2> 2x3", 2, 3, slot_test<cascade<2>>());
  explore_patterns("cascade_k_buffer<3> 2x2", 2, 2, slot_test<cascade<3>>());
  explore_patterns("cascade_k_buffer<4> 2x2 and a reader", 2, 2, slot_test<cascade<4>>(true));
}

TEST_CASE("cascade_k_buffer does so with a minimum by compare-exchange too, and some insert always completes") {
  const auto f =
      explore_patterns("cascade_k_buffer<2> 2x2, exchanged", 2, 2, slot_test<cascade<2, watched_exchanged_slots>>());
  // Three loads and two minima for each thread; a minimum is tried again for each time that the slot fell, at most
  // three times.
  CHECK(f.longest_wait <= 2 * (3 + 2 * 2 * 3));
  explore_patterns("cascade_k_buffer<1> 3x1, exchanged", 3, 1, slot_test<cascade<1, watched_exchanged_slots>>());
}

template <class Storage>
void found(std::string_view name, std::string_view as) {
  expect_found("cascade_k_buffer: " + std::string(name), as, slot_test<cascade<2, Storage>>()(small));
}

TEST_CASE("cascade_k_buffer: each fault is found") {
  found<minimum_in_two_steps>("(3) a minimum in two steps", "the slots are not");
  found<exchanges_blindly>("(3) an exchange that is not verified", "the slots are not");
  found<minimum_without_retry>("(3) a lost retry", "the slots are not");
  found<hands_back_the_smaller>("(3) carries on the smaller", "the slots are not");
  found<looks_at_depth_alone>("(1), (2) compare depths alone", "the slots are not");
  found<refuses_too_early>("(1) looks at the first slot", "the slots are not");
  const auto reads = [](auto test) { return test(small); };
  expect_found("cascade_k_buffer: (4) no barrier before the reader", "the slots are not",
               reads(slot_test<cascade<2>, sound_barrier, missing_barrier>(true)));
  expect_found("cascade_k_buffer: (4) the barrier arrives relaxed", "the slots are not",
               reads(slot_test<cascade<2>, sound_barrier, barrier_arriving_relaxed>(true)));
  expect_found("cascade_k_buffer: (4) the barrier waits relaxed", "the slots are not",
               reads(slot_test<cascade<2>, sound_barrier, barrier_waiting_relaxed>(true)));
}

TEST_CASE("correct variants of the cascade are not reported") {
  expect_sound("cascade_k_buffer, all seq_cst", slot_test<cascade<2, seq_cst_slots>>()(small));
  expect_sound("cascade_k_buffer, nothing passed over", slot_test<cascade<2, passes_nothing_over>>()(small));
  expect_sound("cascade_k_buffer, exchanged, and a reader",
               slot_test<cascade<2, watched_exchanged_slots>>(true)(small));
}

}  // namespace
