// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/atomic_cells.hpp>

#include "property.hpp"
#include "visibility/cells.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pelage::test {

/// Makes every change of some values by some threads; the cells then: all bits, the least, the greatest, the sum by
/// both ways.
template <class Storage>
std::vector<std::uint32_t> changed_by(std::uint32_t threads, const std::vector<std::uint32_t>& values) {
  cells_of<Storage> storage(6u, 0u);
  static_cast<void>(storage.compare_exchange(1u, 0u, 0xffffffffu, std::memory_order_relaxed));
  deal_to_threads(threads, values.size(), [&](std::size_t i) {
    set_bits(storage, 0u, values[i]);
    lower_cell(storage, 1u, values[i]);
    raise_cell(storage, 2u, values[i]);
    add_to_cell(storage, 3u, values[i]);
    add_and_mark(storage, 4u, values[i], 5u, 2u);
  });
  std::vector<std::uint32_t> cells(storage.memory().begin(), storage.memory().begin() + 4);
  cells.push_back(load_marked(storage, 4u, 5u, 2u));
  return cells;
}

std::vector<std::uint32_t> expected_of(const std::vector<std::uint32_t>& values) {
  std::uint32_t bits = 0u;
  std::uint32_t least = 0xffffffffu;
  std::uint32_t greatest = 0u;
  std::uint64_t sum = 0u;
  for (const std::uint32_t v : values) {
    bits |= v;
    least = std::min(least, v);
    greatest = std::max(greatest, v);
    sum += v;
  }
  const auto held = static_cast<std::uint32_t>(std::min<std::uint64_t>(sum, 0xffffffffu));
  return {bits, least, greatest, held, held};
}

TEST_CASE("changes end in the same cells for 1 to 8 threads, the sum clamped to the end of its range") {
  holds("any values", [] {
    const auto values = *rc::gen::container<std::vector<std::uint32_t>>(
        rc::gen::oneOf(rc::gen::arbitrary<std::uint32_t>(), rc::gen::element<std::uint32_t>(0u, 1u, 0x80000000u),
                       rc::gen::inRange<std::uint32_t>(0u, 1000u)));
    for (std::uint32_t threads = 1u; threads <= 8u; threads *= 2u) {
      RC_ASSERT(changed_by<shaken_cells>(threads, values) == expected_of(values));
    }
  });
}

TEST_CASE("20,000 changes at full speed are all in the cells") {
  std::vector<std::uint32_t> values;
  for (std::uint32_t i = 0u; i < 20000u; ++i) {
    values.push_back(i * 7919u % 100003u);
  }
  CHECK(changed_by<atomic_cells<std::uint32_t>>(8u, values) == expected_of(values));
}

TEST_CASE("seeded: cells that change in two steps lose changes") {
  std::vector<std::uint32_t> values(4000u, 1u);
  CHECK(changed_by<torn_cells>(1u, values) == expected_of(values));
  std::uint32_t lost = 0u;
  for (int attempt = 0; attempt < 20 && lost == 0u; ++attempt) {
    lost = 4000u - changed_by<torn_cells>(8u, values)[3];
  }
  CHECK(lost > 0u);
}

TEST_CASE("a sum of amounts stops at the end of the range") {
  holds("as 64-bit integers", [](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t sum = std::uint64_t{a} + b;
    RC_ASSERT(add_saturating(a, b) == std::min<std::uint64_t>(sum, std::numeric_limits<std::uint32_t>::max()));
  });
}

}  // namespace pelage::test
