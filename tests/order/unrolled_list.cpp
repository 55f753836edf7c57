// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/unrolled_list.hpp>

#include "order/unsorted_faults.hpp"
#include "property.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pelage::test {

namespace {

using unrolled_list::node_block;

/// The structure under test, for broken_law().
struct unrolled_lists {
  static constexpr std::uint32_t limit = 0xffffffffu;

  static fragment insert(auto& storage, std::uint32_t list, fragment f) {
    std::vector<offer> returned;
    push_block(storage, list, std::span(&f, 1), returned);
    return returned.empty() ? no_fragment() : f;
  }
  static std::uint32_t first(const auto& storage, std::uint32_t list) { return unrolled_list::first(storage, list); }
  static std::uint32_t next(const auto& storage, std::uint32_t node) { return unrolled_list::next(storage, node); }

  /// Pushes fragments as one block, and notes and counts those that are none or find no node.
  static void push_block(auto& storage, std::uint32_t list, std::span<const fragment> some,
                         std::vector<offer>& returned) {
    std::vector<fragment> real;
    for (const fragment f : some) {
      if (is_fragment(f)) {
        real.push_back(f);
      } else {
        refuse(storage, list, f, returned);
      }
    }
    const node_block block = unrolled_list::take(storage, static_cast<std::uint32_t>(real.size()));
    for (std::uint32_t i = 0u; i < real.size(); ++i) {
      if (i < block.size) {
        storage.write_node(block.first + i, real[i]);
      } else {
        refuse(storage, list, real[i], returned);
      }
    }
    unrolled_list::push(storage, list, block);
  }

  static void refuse(auto& storage, std::uint32_t list, fragment f, std::vector<offer>& returned) {
    storage.add_refused(std::memory_order_relaxed);
    returned.push_back(offer{list, f});
  }
};

/// Deals the offers to the threads like cards. A thread pushes what it has for a list in blocks of up to `most`, and
/// returns what came back.
template <class Storage>
std::vector<offer> push_all(Storage& storage, const std::vector<offer>& offers, std::uint32_t threads,
                            std::uint32_t most) {
  std::vector<std::vector<offer>> returned(threads);
  in_threads(threads, [&](std::uint32_t thread) {
    std::vector<std::vector<fragment>> waiting(storage.list_count());
    const auto push = [&](std::uint32_t list) {
      unrolled_lists::push_block(storage, list, waiting[list], returned[thread]);
      waiting[list].clear();
    };
    for (std::size_t i = thread; i < offers.size(); i += threads) {
      waiting[offers[i].list].push_back(offers[i].offered);
      if (waiting[offers[i].list].size() == most) push(offers[i].list);
    }
    for (std::uint32_t list = 0u; list < storage.list_count(); ++list) {
      push(list);
    }
  });
  std::vector<offer> all;
  for (const std::vector<offer>& part : returned) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

TEST_CASE("every list holds exactly what was pushed, except for what the pool refuses and counts") {
  holds("1 to 8 threads, every capacity, blocks of up to 9", [] {
    const std::vector<offer> offers = *any_offers();
    const auto most = *rc::gen::inRange(1u, 10u);
    for (const std::uint32_t capacity : telling_capacities(offers)) {
      for (std::uint32_t threads = 1u; threads <= 8u; ++threads) {
        pool<shaken> storage(3u, capacity);
        const std::vector<offer> returned = push_all(storage, offers, threads, most);
        RC_ASSERT(broken_law(storage, unrolled_lists{}, offers, returned, most * threads) == "");
      }
    }
  });
}

TEST_CASE("a k_buffer reads the same bits from a list, however many threads pushed it in whatever blocks") {
  holds("1 to 8 threads", [] {
    const std::vector<offer> offers = *any_offers();
    for (std::uint32_t threads = 1u; threads <= 8u; ++threads) {
      pool<shaken> storage(3u, acceptable(offers));
      static_cast<void>(push_all(storage, offers, threads, 1u + threads % 4u));
      for (std::uint32_t list = 0u; list < 3u; ++list) {
        k_buffer<8> nearest = k_buffer<8>::empty();
        const auto met = walk(storage, unrolled_lists{}, list);
        RC_ASSERT(met.has_value());
        for (const fragment f : *met) {
          static_cast<void>(nearest.insert(f));
        }
        nearest.sort();
        RC_ASSERT(bits(nearest.slot) == bits(in_order(offered_to(list, offers), 0u, 8u)));
      }
    }
  });
}

TEST_CASE("a list is its blocks, the last pushed first, each in its own order") {
  holds("any blocks, of which only a beginning may be written", [] {
    const auto blocks = *rc::gen::container<std::vector<std::vector<std::uint8_t>>>(
        rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>()));
    std::uint32_t taken = 0u;
    std::vector<fragment> expected;
    for (const auto& block : blocks) {
      taken += static_cast<std::uint32_t>(block.size()) + 2u;
      std::vector<fragment> front;
      for (const std::uint8_t id : block) {
        front.push_back(fragment{1.0f, id});
      }
      expected.insert(expected.begin(), front.begin(), front.end());
    }
    pool<atomic_list_storage> storage(2u, taken);
    for (const auto& block : blocks) {
      const auto used = static_cast<std::uint32_t>(block.size());
      const node_block nodes = unrolled_list::take(storage, used + 2u);
      RC_ASSERT(nodes.size == used + 2u);
      for (std::uint32_t i = 0u; i < used; ++i) {
        storage.write_node(nodes.first + i, fragment{1.0f, block[i]});
      }
      unrolled_list::push(storage, 1u, unrolled_list::part(nodes, 0u, used));
    }
    const auto met = walk(storage, unrolled_lists{}, 1u);
    RC_ASSERT(met.has_value());
    RC_ASSERT(bits(*met) == bits(expected));
    RC_ASSERT(unrolled_list::first(storage, 0u) == no_node());
  });
}

TEST_CASE("parts of a block side by side are the block, and none reaches beyond it") {
  holds("any cuts, none of which wraps", [] {
    const node_block whole{*rc::gen::inRange(0u, 1000u), *rc::gen::inRange(0u, 100u)};
    const auto offset = *rc::gen::element(0u, 1u, 99u, *rc::gen::inRange(0u, 200u), 0xffffffffu);
    const auto wanted = *rc::gen::element(0u, 1u, *rc::gen::inRange(0u, 200u), 0xffffffffu);
    const node_block part = unrolled_list::part(whole, offset, wanted);
    std::uint32_t size = 0u;
    for (std::uint64_t i = offset; i < std::uint64_t{offset} + wanted && i < whole.size; ++i) {
      ++size;
    }
    RC_ASSERT(part.size == size);
    RC_ASSERT(size == 0u || part.first == whole.first + offset);
    RC_ASSERT(part.first <= whole.first + whole.size);
  });
}

TEST_CASE("two lists take 40,000 fragments in blocks from 8 threads at full speed, and refuse the last 1,000") {
  std::vector<offer> offers;
  for (std::uint32_t i = 0u; i < 40000u; ++i) {
    offers.push_back(offer{i / 3u % 2u, fragment{static_cast<float>(i * 7919u % 1000u), i}});
  }
  pool<atomic_list_storage> storage(2u, 39000u);
  const std::vector<offer> returned = push_all(storage, offers, 8u, 13u);
  CHECK(broken_law(storage, unrolled_lists{}, offers, returned, 13u * 8u) == "");
  CHECK(returned.size() == 1000u);
}

// From here on the checks are themselves checked: each fault must be found, and by the law that it breaks.

template <class Storage>
std::string law_broken_by(std::uint32_t capacity, const std::vector<offer>& offers = two) {
  return interrupted_law<Storage, unrolled_lists>(capacity, offers);
}

TEST_CASE("seeded: without a fault the checks find none") {
  CHECK(law_broken_by<interrupted>(0u) == "");
  CHECK(law_broken_by<interrupted>(1u) == "");
  CHECK(law_broken_by<interrupted>(2u) == "");
}

TEST_CASE("seeded: an exchange in two steps loses the block pushed between them") {
  CHECK(law_broken_by<torn_exchange>(2u) == "a fragment is not exactly once in its list or returned");
}

struct torn_take : interrupted {
  std::uint32_t add_taken_nodes(std::uint32_t count, std::memory_order order) {
    const std::uint32_t found = load_taken(order);
    interrupt();
    std::atomic_ref(*taken).store(found + count, order);
    return found;
  }
};

TEST_CASE("seeded: a counter in two steps gives a node to two") {
  CHECK(law_broken_by<torn_take>(2u) != "");
}

struct ends_nothing : interrupted {
  void store_link(std::uint32_t link, std::uint32_t node, std::memory_order order) {
    interrupted::store_link(link, node == unrolled_list::list_end() ? no_node() : node, order);
  }
};

TEST_CASE("seeded: a list whose end is not stored runs on through the pool") {
  CHECK(law_broken_by<ends_nothing>(2u) == "a list does not end in the pool");
}

}  // namespace

}  // namespace pelage::test
