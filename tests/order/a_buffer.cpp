// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/k_buffer.hpp>

#include "order/unsorted_faults.hpp"
#include "property.hpp"

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace pelage::test {

/// The structure under test, for offer_all() and broken_law().
struct unsorted_lists {
  static constexpr std::uint32_t limit = 0xffffffffu;

  static fragment insert(auto& storage, std::uint32_t list, fragment f) { return a_buffer::push(storage, list, f); }
  static std::uint32_t first(const auto& storage, std::uint32_t list) { return a_buffer::first(storage, list); }
  static std::uint32_t next(const auto& storage, std::uint32_t node) { return a_buffer::next(storage, node); }
};

/// A list's nearest, as a renderer reads them.
template <std::uint32_t K>
std::vector<std::uint64_t> nearest(const auto& storage, std::uint32_t list) {
  k_buffer<K> buffer = k_buffer<K>::empty();
  for (std::uint32_t node = a_buffer::first(storage, list); node != no_node(); node = a_buffer::next(storage, node)) {
    static_cast<void>(buffer.insert(storage.read_node(node)));
  }
  buffer.sort();
  return bits(buffer.slot);
}

TEST_CASE("every list holds exactly what was pushed, except for what the pool refuses and counts") {
  holds("1 to 8 threads, every capacity", [] {
    const std::vector<offer> offers = *any_offers();
    for (const std::uint32_t capacity : telling_capacities(offers)) {
      for (std::uint32_t threads = 1u; threads <= 8u; ++threads) {
        pool<shaken> storage(3u, capacity);
        const std::vector<offer> returned = offer_all(storage, unsorted_lists{}, offers, threads);
        RC_ASSERT(broken_law(storage, unsorted_lists{}, offers, returned, threads) == "");
      }
    }
  });
}

TEST_CASE("a k_buffer reads the same bits from a list, however many threads pushed it") {
  holds("1 to 8 threads", [] {
    const std::vector<offer> offers = *any_offers();
    for (std::uint32_t threads = 1u; threads <= 8u; ++threads) {
      pool<shaken> storage(3u, acceptable(offers));
      static_cast<void>(offer_all(storage, unsorted_lists{}, offers, threads));
      for (std::uint32_t list = 0u; list < 3u; ++list) {
        RC_ASSERT(nearest<8u>(storage, list) == bits(in_order(offered_to(list, offers), 0u, 8u)));
      }
    }
  });
}

TEST_CASE("two lists take 40,000 fragments from 8 threads at full speed, and refuse the last 1,000") {
  std::vector<offer> offers;
  for (std::uint32_t i = 0u; i < 40000u; ++i) {
    offers.push_back(offer{i / 3u % 2u, fragment{static_cast<float>(i * 7919u % 1000u), i}});
  }
  pool<atomic_list_storage> storage(2u, 39000u);
  const std::vector<offer> returned = offer_all(storage, unsorted_lists{}, offers, 8u);
  CHECK(broken_law(storage, unsorted_lists{}, offers, returned, 8u) == "");
  CHECK(returned.size() == 1000u);
}

// From here on the checks are themselves checked: each fault must be found, and by the law that it breaks.

template <class Storage>
std::string law_broken_by(std::uint32_t capacity, const std::vector<offer>& offers = two) {
  return interrupted_law<Storage, unsorted_lists>(capacity, offers);
}

TEST_CASE("seeded: without a fault the checks find none") {
  CHECK(law_broken_by<interrupted>(0u) == "");
  CHECK(law_broken_by<interrupted>(1u) == "");
  CHECK(law_broken_by<interrupted>(2u) == "");
}

TEST_CASE("seeded: an exchange in two steps loses the fragment pushed between them") {
  CHECK(law_broken_by<torn_exchange>(2u) == "a fragment is not exactly once in its list or returned");
}

struct torn_count : interrupted {
  void add_refused(std::memory_order order) {
    const std::uint32_t found = std::atomic_ref(*refused).load(order);
    interrupt();
    std::atomic_ref(*refused).store(found + 1u, order);
  }
};

TEST_CASE("seeded: a count in two steps forgets the refusal between them") {
  CHECK(law_broken_by<torn_count>(0u) == "a refused fragment is not counted");
}

struct returns_the_new_value : interrupted {
  std::uint32_t exchange_link(std::uint32_t link, std::uint32_t node, std::memory_order order) {
    store_link(link, node, order);
    return node;
  }
};

TEST_CASE("seeded: an exchange that returns the new value ties a node to itself") {
  CHECK(law_broken_by<returns_the_new_value>(2u) == "a list does not end in the pool");
}

struct hands_out_all_but_one : interrupted {
  std::uint32_t load_taken(std::memory_order order) const { return interrupted::load_taken(order) + 1u; }
};

TEST_CASE("seeded: a pool that keeps its last node to itself refuses without need") {
  CHECK(law_broken_by<hands_out_all_but_one>(2u) == "a fragment is refused while the pool has room");
}

struct counts_every_push : interrupted {
  void write_node(std::uint32_t node, fragment f) {
    interrupted::write_node(node, f);
    add_refused(std::memory_order_relaxed);
  }
};

TEST_CASE("seeded: a count of what was not refused") {
  CHECK(law_broken_by<counts_every_push>(2u) == "a fragment counted as refused is not");
}

/// Takes a node for what it then refuses.
struct takes_first : interrupted {
  void add_refused(std::memory_order order) {
    static_cast<void>(take_node(*this));
    interrupted::add_refused(order);
  }
};

TEST_CASE("seeded: a node taken for a refused fragment is gone") {
  const std::vector<offer> offers = {{0u, fragment{2.0f, 2u}}, {0u, fragment{1.0f, 0xffffffffu}}};
  CHECK(law_broken_by<takes_first>(3u, offers) == "a node taken is in no list");
}

/// Takes without looking first, so that every push to the full pool moves the counter on.
struct without_bound : shaken {
  std::uint32_t load_taken(std::memory_order) const { return 0u; }
};

/// An overflow as samples have it: the head is exchanged for no node.
struct cuts_lists_when_full : unsorted_lists {
  static fragment insert(auto& storage, std::uint32_t list, fragment f) {
    const fragment answer = a_buffer::push(storage, list, f);
    if (bits(answer) == bits(f)) storage.store_link(list, no_node(), std::memory_order_relaxed);
    return answer;
  }
};

/// Torn, and left to chance instead of being interrupted where it hurts.
struct torn_by_chance : shaken {
  std::uint32_t exchange_link(std::uint32_t link, std::uint32_t node, std::memory_order order) {
    const std::uint32_t found = load_link(link, order);
    store_link(link, node, order);
    return found;
  }
};

TEST_CASE("seeded: real threads find these faults too") {
  CHECK(law_broken_by_threads<without_bound, unsorted_lists>(10u) == "the pool's counter runs away");
  CHECK(law_broken_by_threads<shaken, cuts_lists_when_full>(10u) ==
        "a fragment is not exactly once in its list or returned");
  CHECK(law_broken_by_threads<torn_by_chance, unsorted_lists>(100u) ==
        "a fragment is not exactly once in its list or returned");
}

}  // namespace pelage::test
