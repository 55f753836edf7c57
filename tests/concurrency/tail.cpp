// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// atomic_tail under every schedule of small cases near the end of its range, and with faults planted.
#include <pelage/composite/atomic_tail.hpp>

#include "concurrency/report.hpp"
#include "concurrency/watched_cells.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

namespace {

using namespace pelage;
using namespace pelage::explore;

/// The cells of an atomic_tail's pixel.
struct watched_words : watched_cells<std::uint32_t> {
  watched_words() { add_cells(tail_words(), "word", 0u); }
};

struct adds_in_two_steps : watched_words {
  std::uint32_t fetch_add(std::uint32_t word, std::uint32_t value, std::memory_order order) {
    const std::uint32_t held = cell(word).load(order);
    cell(word).store(held + value, order);
    return held;
  }
};

struct sets_bits_in_two_steps : watched_words {
  std::uint32_t fetch_or(std::uint32_t word, std::uint32_t bits, std::memory_order order) {
    const std::uint32_t held = cell(word).load(order);
    cell(word).store(held | bits, order);
    return held;
  }
};

struct forgets_the_end : watched_words {
  std::uint32_t fetch_or(std::uint32_t, std::uint32_t, std::memory_order) { return 0u; }
};

/// Threads that add tails; in the end their merge() must be there.
template <class Storage>
class tail_program : public program {
 public:
  explicit tail_program(std::vector<std::vector<tail>> parts) : parts_(std::move(parts)) {}
  [[nodiscard]] int threads() const override { return static_cast<int>(parts_.size()); }
  void thread(int t) override {
    for (const tail& one : parts_[static_cast<std::size_t>(t)]) {
      atomic_tail::add(storage_, 0u, one);
      completed();
    }
  }
  void finish() override {
    tail merged = empty_tail();
    for (const auto& of_one : parts_) {
      for (const tail& one : of_one) {
        merged = merge(merged, one);
      }
    }
    const tail held = atomic_tail::load(storage_, 0u);
    expect(held.optical == merged.optical && held.weight == merged.weight && held.red == merged.red &&
               held.green == merged.green && held.blue == merged.blue,
           "the tail is not the merge of its parts");
  }

 private:
  std::vector<std::vector<tail>> parts_;
  Storage storage_;
};

template <class Storage>
program_factory tail_test(std::vector<std::vector<tail>> parts) {
  return [=] { return std::make_unique<tail_program<Storage>>(parts); };
}

/// Two sums that pass the end of their range, in whichever order; one that just does not.
const std::vector<std::vector<tail>> near_the_end = {{{0xfffffff0u, 0x80000000u, 0x7fffffffu, 0u, 0u}},
                                                     {{0x10u, 0x80000000u, 0x80000000u, 0u, 0u}}};

const std::vector<std::vector<tail>> three_threads = {{{0xfffffff0u, 0x90000000u, 0u, 0u, 0u}, {1u, 0u, 0u, 0u, 0u}},
                                                      {{0x8u, 0x90000000u, 0u, 0u, 0u}, {1u, 0u, 0u, 0u, 0u}},
                                                      {{0x7u, 0x90000000u, 0u, 0u, 0u}, {1u, 0u, 0u, 0u, 0u}}};

TEST_CASE("atomic_tail holds what merge() gives, saturated or not, under every schedule") {
  expect_sound("atomic_tail 2x1, end of range", tail_test<watched_words>(near_the_end));
  expect_sound("atomic_tail 3x2, end of range", tail_test<watched_words>(three_threads));
}

TEST_CASE("atomic_tail: each fault is found") {
  const std::string as = "the tail is not the merge of its parts";
  expect_found("atomic_tail: (1) an addition in two steps", as, tail_test<adds_in_two_steps>(near_the_end));
  expect_found("atomic_tail: (2) bits set in two steps", as, tail_test<sets_bits_in_two_steps>(near_the_end));
  expect_found("atomic_tail: (2) the passed end left out", as, tail_test<forgets_the_end>(near_the_end));
}

}  // namespace
