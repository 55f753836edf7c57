// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/list_storage.hpp>

#include "order/lists.hpp"
#include "property.hpp"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace pelage::test {

constexpr std::memory_order relaxed = std::memory_order_relaxed;

TEST_CASE("a cleared storage has empty lists, no node taken and nothing refused") {
  pool<atomic_list_storage> storage(2u, 3u);
  storage.store_link(0u, 1u, relaxed);
  storage.store_link(link_of(storage, 2u), 0u, relaxed);
  storage.add_refused(relaxed);
  CHECK(storage.add_taken(relaxed) == 0u);
  storage.clear();
  CHECK(storage.list_count() == 2u);
  CHECK(storage.node_capacity() == 3u);
  CHECK(storage.load_taken(relaxed) == 0u);
  CHECK(*storage.refused == 0u);
  for (std::uint32_t link = 0u; link < 5u; ++link) {
    CHECK(storage.load_link(link, relaxed) == no_node());
  }
}

TEST_CASE("every list and every node has a link of its own") {
  pool<atomic_list_storage> storage(2u, 3u);
  for (std::uint32_t list = 0u; list < 2u; ++list) {
    storage.store_link(list, 100u + list, relaxed);
  }
  for (std::uint32_t node = 0u; node < 3u; ++node) {
    storage.store_link(link_of(storage, node), node, relaxed);
    storage.write_node(node, fragment{0.5f, node});
  }
  for (std::uint32_t node = 0u; node < 3u; ++node) {
    CHECK(storage.load_link(link_of(storage, node), relaxed) == node);
    CHECK(bits(storage.read_node(node)) == bits(fragment{0.5f, node}));
  }
  CHECK(storage.exchange_link(1u, 7u, relaxed) == 101u);
  CHECK(storage.load_link(1u, relaxed) == 7u);
  CHECK(storage.load_link(0u, relaxed) == 100u);
}

TEST_CASE("a compare-exchange returns what it found, and takes place exactly when that was expected") {
  holds("any values", [](std::uint32_t held, std::uint32_t expected, std::uint32_t desired, bool as_expected) {
    pool<atomic_list_storage> storage(1u, 0u);
    storage.store_link(0u, as_expected ? expected : held, relaxed);
    const std::uint32_t before = storage.load_link(0u, relaxed);
    RC_ASSERT(storage.compare_exchange_link(0u, expected, desired, relaxed) == before);
    RC_ASSERT(storage.load_link(0u, relaxed) == (before == expected ? desired : before));
  });
}

/// The first law of take_node() that some threads break, each asking `requests` times; "" if they keep them all.
template <class Storage>
std::string broken_pool_law(std::uint32_t capacity, std::uint32_t threads, std::uint32_t requests) {
  pool<Storage> storage(1u, capacity);
  std::vector<std::vector<std::uint32_t>> taken(threads);
  in_threads(threads, [&](std::uint32_t thread) {
    for (std::uint32_t i = 0u; i < requests; ++i) {
      const std::uint32_t node = take_node(storage);
      if (node != no_node()) taken[thread].push_back(node);
    }
  });
  std::vector<std::uint32_t> all;
  for (const std::vector<std::uint32_t>& part : taken) {
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end());
  if (std::adjacent_find(all.begin(), all.end()) != all.end()) return "a node is handed out twice";
  if (!all.empty() && all.back() >= capacity) return "a node is not of the pool";
  if (all.size() != std::min(capacity, threads * requests)) return "a node is withheld";
  if (*storage.taken > all.size() + threads - 1u) return "more than one request a thread goes beyond the pool";
  return "";
}

TEST_CASE("the pool hands out every node once, then none, and its counter stays near") {
  for (std::uint32_t threads = 1u; threads <= 8u; ++threads) {
    for (const std::uint32_t capacity : {0u, 1u, 99u * threads, 100u * threads, 101u * threads}) {
      CHECK(broken_pool_law<shaken>(capacity, threads, 100u) == "");
      CHECK(broken_pool_law<atomic_list_storage>(capacity, threads, 100u) == "");
    }
  }
}

/// All eight threads see room in the pool before any of them takes.
struct all_see_room : atomic_list_storage {
  std::atomic<int> requests = 0;

  std::uint32_t add_taken(std::memory_order order) {
    ++requests;
    while (requests < 8) {
      std::this_thread::yield();
    }
    return atomic_list_storage::add_taken(order);
  }
};

TEST_CASE("at worst every thread but one takes the counter one beyond the capacity, once") {
  pool<all_see_room> storage(1u, 1u);
  in_threads(8u, [&](std::uint32_t) {
    for (int request = 0; request < 100; ++request) {
      static_cast<void>(take_node(storage));
    }
  });
  CHECK(*storage.taken == 8u);
}

// From here on the checks are themselves checked: each fault must be found, and by the law that it breaks.

/// Both threads read the counter before either writes it.
struct torn_taken : atomic_list_storage {
  std::barrier<> read{2};

  std::uint32_t add_taken(std::memory_order order) {
    const std::uint32_t found = load_taken(order);
    read.arrive_and_wait();
    std::atomic_ref(*taken).store(found + 1u, order);
    return found;
  }
};

struct without_bound : atomic_list_storage {
  std::uint32_t load_taken(std::memory_order) const { return 0u; }
};

struct one_too_few : atomic_list_storage {
  std::uint32_t load_taken(std::memory_order order) const { return atomic_list_storage::load_taken(order) + 1u; }
};

struct one_too_many : atomic_list_storage {
  std::uint32_t add_taken(std::memory_order order) { return atomic_list_storage::add_taken(order) + 1u; }
  std::uint32_t node_capacity() const { return atomic_list_storage::node_capacity() + 1u; }
};

TEST_CASE("seeded: the faults of a pool are found") {
  CHECK(broken_pool_law<torn_taken>(2u, 2u, 1u) == "a node is handed out twice");
  CHECK(broken_pool_law<without_bound>(10u, 1u, 12u) == "more than one request a thread goes beyond the pool");
  CHECK(broken_pool_law<one_too_few>(10u, 1u, 12u) == "a node is withheld");
  CHECK(broken_pool_law<one_too_many>(10u, 1u, 12u) == "a node is not of the pool");
}

}  // namespace pelage::test
