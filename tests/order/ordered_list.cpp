// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/ordered_list.hpp>

#include "order/lists.hpp"
#include "property.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace pelage::test {

/// The structure under test, for offer_all() and broken_law().
struct ordered_lists {
  std::uint32_t limit = ordered_list::unlimited();

  fragment insert(auto& storage, std::uint32_t list, fragment f) const {
    return ordered_list::insert(storage, list, f, limit);
  }
  static std::uint32_t first(const auto& storage, std::uint32_t list) { return ordered_list::first(storage, list); }
  static std::uint32_t next(const auto& storage, std::uint32_t node) { return ordered_list::next(storage, node); }
};

/// As broken_law(), and lists are sorted.
template <class Storage, class Lists>
std::string broken_order(const Storage& storage, const Lists& lists, const std::vector<offer>& offers,
                         const std::vector<offer>& returned, std::uint32_t threads) {
  std::string law = broken_law(storage, lists, offers, returned, threads);
  for (std::uint32_t list = 0u; law.empty() && list < storage.list_count(); ++list) {
    const std::vector<fragment> met = *walk(storage, lists, list);
    if (!std::is_sorted(met.begin(), met.end(), nearer)) return "a list is out of order";
  }
  return law;
}

/// True if every list begins with the `limit` nearest of all that was offered.
template <class Storage, class Lists>
bool begin_with_the_nearest(const Storage& storage, const Lists& lists, const std::vector<offer>& offers) {
  bool begin = true;
  for (std::uint32_t list = 0u; list < storage.list_count(); ++list) {
    const std::vector<fragment> all = in_order(offered_to(list, offers));
    const std::size_t count = std::min<std::size_t>(all.size(), lists.limit);
    std::vector<fragment> met = walk(storage, lists, list).value();
    met.resize(std::max(met.size(), count), no_fragment());
    begin = begin && std::equal(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), met.begin(),
                                [](fragment a, fragment b) { return bits(a) == bits(b); });
  }
  return begin;
}

std::ostream& operator<<(std::ostream& out, const ordered_lists& lists) {
  return out << "limit " << lists.limit;
}

rc::Gen<ordered_lists> any_limit() {
  return rc::gen::map(rc::gen::element(1u, 2u, 8u, 30u, ordered_list::unlimited()),
                      [](std::uint32_t limit) { return ordered_lists{limit}; });
}

TEST_CASE("lists end sorted and whole, with what was refused counted") {
  holds("1 to 8 threads, every capacity, any limit", [] {
    const std::vector<offer> offers = *any_offers();
    const ordered_lists lists = *any_limit();
    for (const std::uint32_t capacity : telling_capacities(offers)) {
      for (std::uint32_t threads = 1u; threads <= 8u; ++threads) {
        pool<shaken> storage(3u, capacity);
        const std::vector<offer> returned = offer_all(storage, lists, offers, threads);
        RC_ASSERT(broken_order(storage, lists, offers, returned, threads) == "");
      }
    }
  });
}

TEST_CASE("lists begin with the same bits, the nearest of all, however many threads inserted them") {
  holds("1 to 8 threads, any limit", [] {
    const std::vector<offer> offers = *any_offers();
    const ordered_lists lists = *any_limit();
    for (std::uint32_t threads = 1u; threads <= 8u; ++threads) {
      pool<shaken> storage(3u, acceptable(offers));
      static_cast<void>(offer_all(storage, lists, offers, threads));
      RC_ASSERT(begin_with_the_nearest(storage, lists, offers));
    }
  });
}

/// Fragments for two lists, few depths for many fragments.
std::vector<offer> crowd(std::uint32_t count) {
  std::vector<offer> offers;
  for (std::uint32_t i = 0u; i < count; ++i) {
    offers.push_back(offer{i / 3u % 2u, fragment{static_cast<float>(i * 7919u % 50u), i * 0x9e3779b9u}});
  }
  return offers;
}

TEST_CASE("two lists take crowds from 8 threads at full speed") {
  for (const auto& [count, limit] : {std::pair(2000u, ordered_list::unlimited()), std::pair(40000u, 16u)}) {
    const std::vector<offer> offers = crowd(count);
    const ordered_lists lists{limit};
    pool<atomic_list_storage> storage(2u, count);
    const std::vector<offer> returned = offer_all(storage, lists, offers, 8u);
    CHECK(broken_order(storage, lists, offers, returned, 8u) == "");
    CHECK(begin_with_the_nearest(storage, lists, offers));
  }
}

/// What a reader sees of one list while others insert: the first law that it finds broken, or "".
class reader {
 public:
  reader(std::uint32_t list, const std::vector<offer>& offers) : list_(list), all_(bits(offered_to(list, offers))) {
    std::sort(all_.begin(), all_.end());
  }

  template <class Storage>
  std::string look(const Storage& storage) {
    const std::optional<std::vector<fragment>> met = walk(storage, ordered_lists{}, list_);
    if (!met) return "a list does not end in the pool";
    for (const fragment f : *met) {
      const bool offered = std::binary_search(all_.begin(), all_.end(), bits(f));
      if (!offered) return "a reader meets what no one offered";
    }
    if (!std::is_sorted(met->begin(), met->end(), nearer)) return "a reader meets a list out of order";
    const bool keeps = std::includes(met->begin(), met->end(), last_.begin(), last_.end(), nearer);
    last_ = *met;
    return keeps ? "" : "a reader misses what it met before";
  }

 private:
  std::uint32_t list_;
  std::vector<std::uint64_t> all_;
  std::vector<fragment> last_;
};

TEST_CASE("a reader always meets a sorted list of complete nodes, with all that it met before") {
  const std::vector<offer> offers = crowd(1000u);
  for (std::uint32_t writers = 1u; writers <= 6u; ++writers) {
    pool<shaken> storage(2u, 1000u);
    std::atomic<bool> done = false;
    std::vector<std::string> laws(2u);
    std::vector<std::jthread> readers;
    for (std::uint32_t list = 0u; list < 2u; ++list) {
      readers.emplace_back([&, list] {
        reader eye(list, offers);
        do {
          laws[list] = eye.look(storage);
        } while (laws[list].empty() && !done);
      });
    }
    static_cast<void>(offer_all(storage, ordered_lists{}, offers, writers));
    done = true;
    readers.clear();  // joins
    CHECK(laws == std::vector<std::string>{"", ""});
  }
}

// From here on the checks are themselves checked: each fault must be found, and by the law that it breaks.

const std::vector<offer> three = {{0u, fragment{3.0f, 3u}}, {0u, fragment{1.0f, 1u}}, {0u, fragment{2.0f, 2u}}};
const std::vector<offer> ties = {{0u, fragment{1.0f, 2u}}, {0u, fragment{1.0f, 1u}}};

/// Inserts in turn, the last while the last but one is on its way.
template <class Storage, class Lists = ordered_lists>
std::string law_broken_by(const std::vector<offer>& offers, const Lists& lists = {}, std::uint32_t capacity = 9u) {
  pool<Storage> storage(1u, capacity);
  const std::vector<offer> returned = offer_interrupted(storage, lists, offers);
  return broken_order(storage, lists, offers, returned, 2u);
}

/// Gives way before each exchange, as the scheduler may.
struct interrupted_before_exchange : interrupted {
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    interrupt();
    return interrupted::compare_exchange_link(link, expected, desired, order);
  }
};

TEST_CASE("seeded: without a fault the checks find none, whatever comes before an exchange") {
  holds("any offers, any limit, any capacity", [] {
    std::vector<offer> offers = *any_offers();
    RC_PRE(offers.size() >= 2u);
    for (offer& o : offers) {
      o.list = 0u;
    }
    const ordered_lists lists = *any_limit();
    for (const std::uint32_t capacity : telling_capacities(offers)) {
      RC_ASSERT(law_broken_by<interrupted_before_exchange>(offers, lists, capacity) == "");
    }
  });
}

/// Stores whatever it finds.
struct blind_exchange : interrupted {
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    interrupt();
    store_link(link, desired, order);
    return expected;
  }
};

/// Compares, and stores later.
struct torn_exchange : interrupted {
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    const std::uint32_t found = load_link(link, std::memory_order_relaxed);
    interrupt();
    if (found == expected) store_link(link, desired, order);
    return found;
  }
};

TEST_CASE("seeded: an exchange that does not compare, or does so in two steps, loses what came between") {
  CHECK(law_broken_by<blind_exchange>(three) == "a fragment is not exactly once in its list or returned");
  CHECK(law_broken_by<torn_exchange>(three) == "a fragment is not exactly once in its list or returned");
}

/// Treiber's push: takes whatever successor it finds instead of comparing with it again.
struct does_not_verify : interrupted {
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    interrupt();
    std::uint32_t found = expected;
    std::uint32_t successor = no_node();
    do {
      successor = found;
      store_link(list_count() + desired, successor, std::memory_order_relaxed);
      found = interrupted::compare_exchange_link(link, successor, desired, order);
    } while (found != successor);
    return expected;
  }
};

TEST_CASE("seeded: an insert that does not verify its place puts itself before a nearer one") {
  const std::vector<offer> nearer_last = {three[0], three[2], three[1]};
  CHECK(law_broken_by<does_not_verify>(nearer_last) == "a list is out of order");
}

/// Forgets ids, so that ties stay in order of arrival.
struct compares_depth_only : interrupted {
  fragment read_node(std::uint32_t node) const { return fragment{nodes[node].depth, 0u}; }
};

TEST_CASE("seeded: ties in order of arrival are out of order") {
  CHECK(law_broken_by<compares_depth_only>(ties) == "a list is out of order");
}

/// Searches with a limit one smaller than it says.
struct gives_up_early : ordered_lists {
  fragment insert(auto& storage, std::uint32_t list, fragment f) const {
    return ordered_list::insert(storage, list, f, limit - 1u);
  }
};

TEST_CASE("seeded: a search that gives up one node too early loses one of the nearest") {
  const gives_up_early lists{{3u}};
  const std::vector<offer> sorted = {three[1], three[2], three[0]};
  CHECK(law_broken_by<interrupted>(sorted, lists) == "a refused fragment is not counted");

  pool<interrupted> storage(1u, 9u);
  static_cast<void>(offer_interrupted(storage, lists, sorted));
  CHECK(!begin_with_the_nearest(storage, lists, sorted));
}

struct counts_nothing : interrupted {
  void add_refused(std::memory_order) {}
};

TEST_CASE("seeded: NaN or a full pool without a count") {
  const std::vector<offer> with_nan = {three[0], {0u, fragment{std::numeric_limits<float>::quiet_NaN(), 1u}}};
  CHECK(law_broken_by<counts_nothing>(with_nan) == "a refused fragment is not counted");
  CHECK(law_broken_by<counts_nothing>(three, {}, 2u) == "a refused fragment is not counted");
}

/// What a reader finds who looks while each offer is on its way, and after it.
template <class Storage>
std::string reader_law_broken_by(const std::vector<offer>& offers) {
  pool<Storage> storage(1u, 9u);
  reader eye(0u, offers);
  std::string law;
  for (const offer& o : offers) {
    storage.meanwhile = [&] {
      if (law.empty()) law = eye.look(storage);
    };
    CHECK(bits(ordered_list::insert(storage, 0u, o.offered, ordered_list::unlimited())) == bits(no_fragment()));
    if (law.empty()) law = eye.look(storage);
  }
  return law;
}

/// The node's fragment arrives after the link that leads to it.
struct writes_late : interrupted {
  fragment late = no_fragment();

  void write_node(std::uint32_t, fragment f) { late = f; }
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    const std::uint32_t found = interrupted::compare_exchange_link(link, expected, desired, order);
    interrupt();
    interrupted::write_node(desired, late);
    return found;
  }
};

/// The node's own link arrives after the link that leads to it.
struct links_late : interrupted {
  std::uint32_t late = no_node();

  void store_link(std::uint32_t, std::uint32_t node, std::memory_order) { late = node; }
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    const std::uint32_t found = interrupted::compare_exchange_link(link, expected, desired, order);
    interrupt();
    interrupted::store_link(list_count() + desired, late, std::memory_order_relaxed);
    return found;
  }
};

TEST_CASE("seeded: a reader finds what is published too early, and what is out of order") {
  CHECK(reader_law_broken_by<interrupted_before_exchange>(three) == "");
  CHECK(reader_law_broken_by<writes_late>(three) == "a reader meets what no one offered");
  CHECK(reader_law_broken_by<links_late>(three) == "a reader misses what it met before");
  CHECK(reader_law_broken_by<compares_depth_only>(ties) == "a reader meets a list out of order");
}

/// Torn, and left to chance instead of being interrupted where it hurts.
struct torn_by_chance : shaken {
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    const std::uint32_t found = load_link(link, std::memory_order_acquire);
    if (found == expected) store_link(link, desired, order);
    return found;
  }
};

TEST_CASE("seeded: real threads find a torn exchange too") {
  CHECK(law_broken_by_threads<torn_by_chance, ordered_lists>(100u) ==
        "a fragment is not exactly once in its list or returned");
}

}  // namespace pelage::test
