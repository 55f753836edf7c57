// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/unrolled_walk.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "order/lane_fibers.hpp"
#include "order/lists.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

/// Lists of blocks of drawn sizes, in the order in which they are drawn.
struct drawn_lists {
  pool<atomic_list_storage> storage;

  explicit drawn_lists(const std::vector<std::uint32_t>& sizes, std::uint32_t capacity) : storage(3u, capacity) {
    std::uint32_t list = 0u;
    for (const std::uint32_t size : sizes) {
      const unrolled_list::node_block block = unrolled_list::take(storage, size);
      unrolled_list::push(storage, list++ % 3u, unrolled_list::part(block, 0u, size - size / 8u));
    }
  }
};

/// The nodes of a list, one by one.
std::vector<std::uint32_t> nodes_of(const atomic_list_storage& storage, std::uint32_t list) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = unrolled_list::first(storage, list); n != no_node(); n = unrolled_list::next(storage, n)) {
    nodes.push_back(n);
  }
  return nodes;
}

struct step {
  std::uint32_t begin, size, then;
  bool operator==(const step&) const = default;
};

/// The steps of each lane of a group.
std::vector<std::vector<step>> steps_of(const atomic_list_storage& storage, std::uint32_t list, std::uint32_t lanes,
                                        std::string& fault) {
  std::vector<std::vector<step>> seen(lanes);
  lane_fibers group(lanes, 0u);
  fault = group.run([&](auto& lane) {
    unrolled_walk walk;
    walk.go_to(storage, lane, unrolled_list::first(storage, list));
    while (walk.size > 0u) {
      seen[lane.lane()].push_back(step{walk.begin, walk.size, walk.then});
      walk.go_to(storage, lane, walk.then);
    }
  });
  return seen;
}

TEST_CASE("a group meets the nodes of a list in its order, each once, and all lanes agree") {
  holds("blocks of up to 100 nodes, a pool that may be full, groups of 1 to 64", [] {
    const auto sizes = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0u, 101u));
    std::uint32_t all = 0u;
    for (const std::uint32_t size : sizes) {
      all += size;
    }
    const drawn_lists drawn(sizes, *rc::gen::element(all, all / 2u, all + 1u));
    const std::uint32_t lanes = 1u << *rc::gen::inRange(0u, 7u);
    for (std::uint32_t list = 0u; list < 3u; ++list) {
      std::string fault;
      const auto seen = steps_of(drawn.storage, list, lanes, fault);
      RC_ASSERT(fault == "");
      std::vector<std::uint32_t> met;
      for (const step& s : seen[0]) {
        RC_ASSERT(s.size <= lanes);
        for (std::uint32_t l = 0u; l < s.size; ++l) {
          met.push_back(s.begin + l);
        }
      }
      RC_ASSERT(met == nodes_of(drawn.storage, list));
      RC_ASSERT(std::all_of(seen.begin(), seen.end(), [&](const auto& of_lane) { return of_lane == seen[0]; }));
    }
  });
}

TEST_CASE("a block takes as many steps as it fills groups") {
  for (const std::uint32_t size : {1u, 7u, 8u, 9u, 16u, 17u}) {
    const drawn_lists drawn({0u, 0u, 0u, size}, size);  // an eighth of it is not in the list
    const std::uint32_t held = size - size / 8u;
    std::string fault;
    const auto seen = steps_of(drawn.storage, 0u, 8u, fault);
    CHECK(fault == "");
    CHECK(seen[0].size() == (held + 7u) / 8u);
  }
}

}  // namespace

}  // namespace pelage::test
