// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Workloads and schedules that rapidcheck draws and shrinks, larger than what can be explored whole; bounded searches
// of such workloads; and schedules as strings.
#include <pelage/explore/bounded.hpp>

#include "concurrency/drawn.hpp"
#include "concurrency/report.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <string>

namespace {

using namespace pelage;
using namespace pelage::explore;

const structure& named(std::string_view name) {
  return *find_structure(name);
}

void sample_sound(std::string_view name) {
  if (const auto found = sample(named(name))) {
    FAIL_CHECK(name, ": ", found->found.fault, "\npelage-replay --replay '",
               replay_string(named(name), found->made, found->found), "'");
  }
}

TEST_CASE("drawn workloads under drawn schedules hold what the structures promise") {
  for (const std::string_view name :
       {"a_buffer", "unrolled_list", "ordered_list", "atomic_k_buffer", "split_k_buffer"}) {
    sample_sound(name);
  }
}

void sample_fault(std::string_view name, std::string_view as) {
  const std::optional<counterexample> found = sample(named(name));
  REQUIRE_MESSAGE(found, name, ": not found");
  const std::string to_replay = replay_string(named(name), found->made, found->found);
  std::cout << "planted, drawn: " << name << ": " << found->found.fault << " [" << to_replay << "]" << std::endl;
  CHECK(found->found.fault.rfind(as, 0) == 0);
  // Two threads suffice for each of these faults, and three fragments.
  std::size_t fragments = 0;
  for (const auto& of_one : found->made.work) {
    fragments += of_one.size();
  }
  CHECK(found->made.work.size() <= 2);
  CHECK(fragments <= 3);
  // What is printed leads to the same fault again.
  std::string_view text = to_replay;
  CHECK(take_until(text, ' ') == name);
  const auto work = inserts_of(take_until(text, ' '));
  REQUIRE(work);
  std::ostringstream steps;
  CHECK_FALSE(replay(named(name).test(*work), text, steps));
  CHECK(steps.str().find("fault: " + found->found.fault) != std::string::npos);
}

TEST_CASE("a fault is drawn, shrunk to the smallest case, and replayed from its string") {
  sample_fault("ordered_list-no_retry", "a fragment is lost");
  sample_fault("ordered_list-keeps_old_successor", "a fragment is lost");
  sample_fault("ordered_list-publishes_relaxed", "race on node");
}

TEST_CASE("a replay shows each step and the list after it") {
  std::ostringstream steps;
  const inserts work = {{{1.0f, 0u}}, {{1.0f, 1u}}};
  CHECK(replay(named("ordered_list").test(work), "aaaaab1", steps));
  CHECK(steps.str().find("5  a: compare-exchange head, release: - becomes #0\n     head -> #0(1, 0)\n") !=
        std::string::npos);
  CHECK(steps.str().find("6  b: load head, acquire: -\n") != std::string::npos);
  CHECK(steps.str().find("no fault") != std::string::npos);
}

TEST_CASE("inserts are read as they are written, and nothing else is") {
  pelage::test::holds("inserts survive as text", [] {
    const drawn_case made = *any_case();
    RC_PRE(!made.work.empty());
    RC_ASSERT(to_text(inserts_of(to_text(made.work)).value()) == to_text(made.work));
  });
  for (const std::string_view wrong : {"1", "1:", ":1", "x:1", "1:0;", "1:0,1:1x", "nan:1", "1:4294967295", "1:-1"}) {
    CHECK_FALSE(inserts_of(wrong));
  }
}

TEST_CASE("larger cases hold under every schedule of few surprises") {
  const inserts eight = {
      {{3.0f, 0u}, {1.0f, 1u}}, {{2.0f, 3u}, {1.0f, 4u}, {3.0f, 5u}}, {{1.0f, 6u}, {2.0f, 7u}}, {{3.0f, 8u}}};
  for (const std::string_view name :
       {"a_buffer", "unrolled_list", "ordered_list", "atomic_k_buffer", "split_k_buffer"}) {
    const int surprises = name == "ordered_list" ? 1 : 2;  // its reader makes it the longest
    const findings f = report(std::string(name) + " 2+3+2+1, surprises: " + std::to_string(surprises),
                              [&] { return explore_bounded(named(name).test(eight), surprises); });
    CHECK_MESSAGE(f.fault.empty(), name, ": ", f);
    CHECK(f.all);
  }
}

TEST_CASE("the planted faults show within two surprises") {
  const inserts small = {{{2.0f, 7u}, {1.0f, 8u}}, {{2.0f, 3u}}};
  for (const std::string_view name :
       {"ordered_list-no_retry", "ordered_list-keeps_old_successor", "ordered_list-publishes_relaxed"}) {
    const findings f = report("planted: " + std::string(name) + ", 2 surprises",
                              [&] { return explore_bounded(named(name).test(small), 2); });
    CHECK(!f.fault.empty());
  }
}

}  // namespace
