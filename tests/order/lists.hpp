// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/list_storage.hpp>

#include "order/oracle.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <latch>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

/// What the tests of the concurrent lists share: storages, threads, and the laws that every structure keeps.
namespace pelage::test {

/// A storage together with its memory, cleared. Nodes begin as NaN, so that one read too early shows.
template <class Storage>
class pool : public Storage {
 public:
  pool(std::uint32_t lists, std::uint32_t capacity)
      : link_cells_(lists + capacity), node_cells_(capacity, fragment{std::numeric_limits<float>::quiet_NaN(), 0u}) {
    this->links = link_cells_;
    this->nodes = node_cells_;
    this->taken = &taken_cell_;
    this->refused = &refused_cell_;
    this->clear();
  }
  pool(const pool&) = delete;
  pool& operator=(const pool&) = delete;

 private:
  std::vector<std::uint32_t> link_cells_;
  std::vector<fragment> node_cells_;
  std::uint32_t taken_cell_ = 0u;
  std::uint32_t refused_cell_ = 0u;
};

/// Lets other threads run, every few calls: two cores then show the interleavings of many.
inline void give_way() {
  thread_local std::uint32_t calls = 0u;
  calls = calls * 1664525u + 1013904223u;
  if (calls >> 30u == 0u) std::this_thread::yield();
}

/// Gives way before each access to a shared cell.
struct shaken : atomic_list_storage {
  std::uint32_t load_link(std::uint32_t link, std::memory_order order) const {
    give_way();
    return atomic_list_storage::load_link(link, order);
  }
  void store_link(std::uint32_t link, std::uint32_t node, std::memory_order order) {
    give_way();
    atomic_list_storage::store_link(link, node, order);
  }
  std::uint32_t exchange_link(std::uint32_t link, std::uint32_t node, std::memory_order order) {
    give_way();
    return atomic_list_storage::exchange_link(link, node, order);
  }
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    give_way();
    return atomic_list_storage::compare_exchange_link(link, expected, desired, order);
  }
  std::uint32_t add_taken(std::memory_order order) {
    give_way();
    return atomic_list_storage::add_taken(order);
  }
};

/// For seeding faults: what another thread does between two instructions of this one, once.
struct interrupted : atomic_list_storage {
  std::function<void()> meanwhile;

  void interrupt() {
    if (meanwhile) std::exchange(meanwhile, nullptr)();
  }
  /// The other thread's view of the same memory, whose every step is whole.
  atomic_list_storage& other() { return *this; }
};

/// Runs work(0), ..., work(threads - 1), each in a thread of its own; all begin at once.
template <class Work>
void in_threads(std::uint32_t threads, Work work) {
  std::latch start(threads);
  std::vector<std::jthread> running;
  for (std::uint32_t thread = 0u; thread < threads; ++thread) {
    running.emplace_back([&start, &work, thread] {
      start.arrive_and_wait();
      work(thread);
    });
  }
}

/// One fragment offered to one list.
struct offer {
  std::uint32_t list;
  fragment offered;
};

inline std::ostream& operator<<(std::ostream& out, const offer& o) {
  return out << o.offered << " to list " << o.list;
}

/// Any fragments, offered to three lists.
inline rc::Gen<std::vector<offer>> any_offers() {
  return rc::gen::map(any_fragments(), [](const std::vector<fragment>& fragments) {
    std::vector<offer> offers;
    for (const fragment f : fragments) {
      offers.push_back(offer{f.id % 3u, f});
    }
    return offers;
  });
}

/// What was offered to one list.
inline std::vector<fragment> offered_to(std::uint32_t list, const std::vector<offer>& offers) {
  std::vector<fragment> fragments;
  for (const offer& o : offers) {
    if (o.list == list) fragments.push_back(o.offered);
  }
  return fragments;
}

/// How many a pool without end would hold.
inline std::uint32_t acceptable(const std::vector<offer>& offers) {
  return static_cast<std::uint32_t>(
      std::count_if(offers.begin(), offers.end(), [](const offer& o) { return !refusable(o.offered); }));
}

/// The pools worth a test: none, one node, one too few, just enough.
inline std::vector<std::uint32_t> telling_capacities(const std::vector<offer>& offers) {
  const std::uint32_t enough = acceptable(offers);
  return {0u, 1u, std::max(enough, 1u) - 1u, enough};
}

/// Offers a fragment and notes it if it comes back. `Lists` is the structure under test: insert(storage, list,
/// fragment), first(storage, list), next(storage, node), and the `limit` of its lists.
template <class Storage, class Lists>
void offer_one(Storage& storage, const Lists& lists, const offer& o, std::vector<offer>& returned) {
  const fragment answer = lists.insert(storage, o.list, o.offered);
  const bool is_back = bits(answer) != bits(no_fragment()) || refusable(o.offered);
  if (is_back) returned.push_back(offer{o.list, answer});
}

/// Deals the offers to the threads like cards and returns those that came back.
template <class Storage, class Lists>
std::vector<offer> offer_all(Storage& storage, const Lists& lists, const std::vector<offer>& offers,
                             std::uint32_t threads) {
  std::vector<std::vector<offer>> returned(threads);
  in_threads(threads, [&](std::uint32_t thread) {
    for (std::size_t i = thread; i < offers.size(); i += threads) {
      offer_one(storage, lists, offers[i], returned[thread]);
    }
  });
  std::vector<offer> all;
  for (const std::vector<offer>& part : returned) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Offers in turn and returns those that came back. The last comes from another thread, where the storage gives way
/// while it serves the last but one.
template <class Storage, class Lists>
std::vector<offer> offer_interrupted(Storage& storage, const Lists& lists, const std::vector<offer>& offers) {
  std::vector<offer> returned;
  for (std::size_t i = 0u; i + 1u < offers.size(); ++i) {
    if (i + 2u == offers.size()) {
      storage.meanwhile = [&] { offer_one(storage.other(), lists, offers.back(), returned); };
    }
    offer_one(storage, lists, offers[i], returned);
  }
  const bool gave_way = !std::exchange(storage.meanwhile, nullptr);
  if (!gave_way) offer_one(storage, lists, offers.back(), returned);
  return returned;
}

/// A list as a reader meets it, or nothing if it leads out of the pool or does not end.
template <class Storage, class Lists>
std::optional<std::vector<fragment>> walk(const Storage& storage, const Lists& lists, std::uint32_t list) {
  std::vector<fragment> met;
  std::uint32_t node = lists.first(storage, list);
  while (node != no_node()) {
    if (node >= storage.node_capacity() || met.size() == storage.node_capacity()) return std::nullopt;
    met.push_back(storage.nodes[node]);
    node = lists.next(storage, node);
  }
  return met;
}

/// The first law of every concurrent list that the outcome of some inserts breaks, or "" if it keeps them all:
/// nothing is lost, nothing is refused silently or without need, and the pool's counter stays near the capacity.
template <class Storage, class Lists>
std::string broken_law(const Storage& storage, const Lists& lists, const std::vector<offer>& offers,
                       const std::vector<offer>& returned, std::uint32_t threads) {
  std::vector<std::vector<fragment>> held;
  std::vector<std::pair<std::uint32_t, std::uint64_t>> given;
  std::vector<std::pair<std::uint32_t, std::uint64_t>> found;
  for (const offer& o : offers) {
    given.emplace_back(o.list, bits(o.offered));
  }
  for (std::uint32_t list = 0u; list < storage.list_count(); ++list) {
    const std::optional<std::vector<fragment>> met = walk(storage, lists, list);
    if (!met) return "a list does not end in the pool";
    held.push_back(*met);
    for (const fragment f : *met) {
      found.emplace_back(list, bits(f));
    }
  }
  const std::size_t listed = found.size();
  std::size_t refused_by_data = 0u;
  std::size_t refused_by_pool = 0u;  // except those that the limit would have refused as well
  for (const auto& [list, f] : returned) {
    found.emplace_back(list, bits(f));
    const auto nearer_ones =
        std::count_if(held[list].begin(), held[list].end(), [f = f](fragment other) { return nearer(other, f); });
    if (refusable(f)) {
      ++refused_by_data;
    } else if (nearer_ones < std::int64_t{lists.limit}) {
      ++refused_by_pool;
    }
  }
  std::sort(given.begin(), given.end());
  std::sort(found.begin(), found.end());
  if (given != found) return "a fragment is not exactly once in its list or returned";

  const std::uint32_t counted = *storage.refused;
  const bool is_full = listed == storage.node_capacity();
  if (counted < refused_by_data + refused_by_pool) return "a refused fragment is not counted";
  if (refused_by_pool > 0u && !is_full) return "a fragment is refused while the pool has room";
  if (counted > (is_full ? returned.size() : refused_by_data)) return "a fragment counted as refused is not";
  if (std::min(*storage.taken, storage.node_capacity()) != listed) return "a node taken is in no list";
  if (*storage.taken >= storage.node_capacity() + std::max(threads, 1u)) return "the pool's counter runs away";
  return "";
}

/// The law that 8 threads break within 1000 rounds of 100 offers of one fragment to one list, or "".
template <class Storage, class Lists>
std::string law_broken_by_threads(std::uint32_t capacity) {
  const std::vector<offer> offers(100u, offer{0u, fragment{1.0f, 1u}});
  std::string law;
  for (int round = 0; round < 1000 && law.empty(); ++round) {
    pool<Storage> storage(1u, capacity);
    const std::vector<offer> returned = offer_all(storage, Lists{}, offers, 8u);
    law = broken_law(storage, Lists{}, offers, returned, 8u);
  }
  return law;
}

}  // namespace pelage::test
