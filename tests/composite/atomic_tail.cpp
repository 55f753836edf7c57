// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// atomic_tail with real threads; tests/concurrency/tail.cpp explores its schedules.
#include <pelage/composite/atomic_tail.hpp>

#include "order/slots.hpp"
#include "property.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace pelage::test {

std::array<std::uint32_t, 5> sums(const tail& t) {
  return {t.optical, t.weight, t.red, t.green, t.blue};
}

rc::Gen<tail> any_tail() {
  const auto sum = rc::gen::oneOf(rc::gen::element<std::uint32_t>(0u, 1u, 0x7fffffffu, 0x80000000u, 0xffffffffu),
                                  rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()));
  return rc::gen::map(
      rc::gen::tuple(sum, sum, sum, sum, sum),
      [](const std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>& drawn) {
        const auto [optical, weight, red, green, blue] = drawn;
        return tail{optical, weight, red, green, blue};
      });
}

/// What two pixels hold after threads have added to the second one.
std::array<tail, 2> added(const std::vector<tail>& parts, std::uint32_t threads) {
  std::vector<std::uint32_t> words(2u * tail_words(), 0u);
  atomic_cells<std::uint32_t> storage{words};
  in_threads(threads, [&](std::uint32_t t) {
    for (std::size_t i = t; i < parts.size(); i += threads) {
      atomic_tail::add(storage, 1u, parts[i]);
    }
  });
  return {atomic_tail::load(storage, 0u), atomic_tail::load(storage, 1u)};
}

TEST_CASE("a tail that threads add to is the merge of its parts, saturated sums included") {
  holds("atomic_tail, 1 to 4 threads", [] {
    const auto parts = *rc::gen::container<std::vector<tail>>(any_tail());
    tail merged = empty_tail();
    for (const tail& one : parts) {
      merged = merge(merged, one);
    }
    for (std::uint32_t threads = 1u; threads <= 4u; ++threads) {
      const auto [untouched, held] = added(parts, threads);
      RC_ASSERT(sums(held) == sums(merged));
      RC_ASSERT(sums(untouched) == sums(empty_tail()));
    }
  });
}

TEST_CASE("ten thousand fragments from four threads make the tail that one thread makes") {
  std::vector<tail> parts;
  tail merged = empty_tail();
  for (int i = 0; i < 10000; ++i) {
    const float x = static_cast<float>(i % 97) / 97.0f;
    parts.push_back(add_fragment(empty_tail(), x, glm::vec3(x, 1.0f - x, 3.0f)));
    merged = merge(merged, parts.back());
  }
  for (int repeat = 0; repeat < 20; ++repeat) {
    CHECK(sums(added(parts, 4u)[1]) == sums(merged));
  }
}

/// Counts the changes of cells.
struct counted_cells : atomic_cells<std::uint32_t> {
  std::uint32_t changes = 0u;

  std::uint32_t fetch_or(std::uint32_t cell, std::uint32_t bits, std::memory_order order) {
    ++changes;
    return atomic_cells::fetch_or(cell, bits, order);
  }
  std::uint32_t fetch_add(std::uint32_t cell, std::uint32_t amount, std::memory_order order) {
    ++changes;
    return atomic_cells::fetch_add(cell, amount, order);
  }
};

TEST_CASE("a fragment takes an atomic a sum that gains, and one more where the sum passes its end") {
  holds("any two tails", [] {
    std::vector<std::uint32_t> words(tail_words(), 0u);
    counted_cells storage{{words}};
    const tail first = *any_tail();
    const tail second = *any_tail();
    atomic_tail::add(storage, 0u, first);
    storage.changes = 0u;
    atomic_tail::add(storage, 0u, second);
    std::uint32_t expected = 0u;
    for (std::size_t i = 0; i < 5u; ++i) {
      expected += sums(second)[i] == 0u ? 0u : sums(first)[i] > 0xffffffffu - sums(second)[i] ? 2u : 1u;
    }
    RC_ASSERT(storage.changes == expected);
  });
}

}  // namespace pelage::test
