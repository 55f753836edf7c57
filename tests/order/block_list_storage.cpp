// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/block_list_storage.hpp>
#include <pelage/order/ordered_list.hpp>

#include "order/lists.hpp"
#include "property.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace pelage::test {

struct sorted_lists {
  static constexpr std::uint32_t limit = ordered_list::unlimited();

  static fragment insert(auto& storage, std::uint32_t list, fragment f) {
    return ordered_list::insert(storage, list, f, limit);
  }
  static std::uint32_t first(const auto& storage, std::uint32_t list) { return ordered_list::first(storage, list); }
  static std::uint32_t next(const auto& storage, std::uint32_t node) { return ordered_list::next(storage, node); }
};

/// Deals the offers to threads that each have a storage of their own, and returns those that came back.
std::vector<offer> offer_in_blocks(pool<atomic_list_storage>& shared, const std::vector<offer>& offers,
                                   std::uint32_t threads) {
  std::vector<std::vector<offer>> returned(threads);
  in_threads(threads, [&](std::uint32_t thread) {
    block_list_storage mine(shared);
    for (std::size_t i = thread; i < offers.size(); i += threads) {
      offer_one(mine, sorted_lists{}, offers[i], returned[thread]);
    }
  });
  std::vector<offer> all;
  for (const std::vector<offer>& part : returned) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

std::uint32_t enough_for(const std::vector<offer>& offers, std::uint32_t threads) {
  return acceptable(offers) + (block_list_storage::block_size() - 1u) * threads;
}

TEST_CASE("a thread's blocks are its own") {
  CHECK_FALSE(std::is_copy_constructible_v<block_list_storage>);
}

TEST_CASE("lists hold what was offered, in order, whatever the number of threads") {
  holds("1 to 8 threads", [] {
    const std::vector<offer> offers = *any_offers();
    for (std::uint32_t threads = 1u; threads <= 8u; ++threads) {
      pool<atomic_list_storage> storage(3u, enough_for(offers, threads));
      const std::vector<offer> returned = offer_in_blocks(storage, offers, threads);
      RC_ASSERT(returned.size() == offers.size() - acceptable(offers));
      RC_ASSERT(*storage.refused == returned.size());
      for (std::uint32_t list = 0u; list < 3u; ++list) {
        const auto met = walk(storage, sorted_lists{}, list);
        RC_ASSERT(met.has_value());
        RC_ASSERT(bits(*met) == bits(in_order(offered_to(list, offers))));
      }
    }
  });
}

TEST_CASE("40,000 fragments from 8 threads at full speed need 63 nodes more a thread, and no more") {
  std::vector<offer> offers;
  for (std::uint32_t i = 0u; i < 40000u; ++i) {
    offers.push_back(offer{i % 2000u, fragment{static_cast<float>(i * 7919u % 1000u), i}});
  }
  pool<atomic_list_storage> storage(2000u, enough_for(offers, 8u));
  CHECK(offer_in_blocks(storage, offers, 8u).empty());
  CHECK(*storage.taken <= storage.node_capacity() + block_list_storage::block_size() * 8u);
}

TEST_CASE("a pool that is too small hands back and counts what it cannot take, and keeps every list whole") {
  holds("1 to 8 threads, any capacity", [] {
    const std::vector<offer> offers = *any_offers();
    const std::uint32_t threads = *rc::gen::inRange(1u, 9u);
    const std::uint32_t capacity = *rc::gen::inRange(0u, enough_for(offers, threads) + 1u);
    pool<atomic_list_storage> storage(3u, capacity);
    const std::vector<offer> returned = offer_in_blocks(storage, offers, threads);
    std::size_t listed = 0u;
    std::vector<std::uint64_t> given, found;
    for (const offer& o : offers)
      given.push_back(bits(o.offered));
    for (const offer& o : returned)
      found.push_back(bits(o.offered));
    for (std::uint32_t list = 0u; list < 3u; ++list) {
      const auto met = walk(storage, sorted_lists{}, list);
      RC_ASSERT(met.has_value());
      RC_ASSERT(bits(*met) == bits(in_order(*met)));
      listed += met->size();
      for (const fragment f : *met)
        found.push_back(bits(f));
    }
    std::sort(given.begin(), given.end());
    std::sort(found.begin(), found.end());
    RC_ASSERT(given == found);
    RC_ASSERT(*storage.refused == returned.size());
    RC_ASSERT(listed + returned.size() == offers.size());
  });
}

/// The fault that a copy would be: two that hand out the same block.
struct shares_a_block : atomic_list_storage {
  explicit shares_a_block(const atomic_list_storage& shared) : atomic_list_storage(shared) {}
  [[nodiscard]] std::uint32_t add_taken(std::memory_order) { return next++; }
  std::uint32_t next = 0u;
};

TEST_CASE("seeded: two threads that take the same nodes lose fragments") {
  pool<atomic_list_storage> storage(1u, 8u);
  shares_a_block one(storage), other(storage);
  std::vector<offer> returned;
  offer_one(one, sorted_lists{}, offer{0u, fragment{1.0f, 1u}}, returned);
  offer_one(other, sorted_lists{}, offer{0u, fragment{2.0f, 2u}}, returned);
  const auto met = walk(storage, sorted_lists{}, 0u);
  CHECK((!met || met->size() != 2u));
}

}  // namespace pelage::test
