// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// a_buffer, unrolled_list and ordered_list against sorting: any depths, any order, any pool, any limit.
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/ordered_list.hpp>
#include <pelage/order/unrolled_list.hpp>

#include "../input.hpp"

#include <cstddef>
#include <vector>

namespace {

using namespace pelage;

constexpr std::uint32_t list_count = 2u;

struct offer {
  std::uint32_t list;
  fragment offered;
};

struct lists {
  explicit lists(std::uint32_t capacity)
      : links(list_count + capacity), nodes(capacity), storage{links, nodes, &taken, &refused} {
    storage.clear();
  }
  std::vector<std::uint32_t> links;
  std::vector<fragment> nodes;
  std::uint32_t taken = 0;
  std::uint32_t refused = 0;
  atomic_list_storage storage;
};

std::vector<fragment> walk(const lists& l, std::uint32_t list) {
  std::vector<fragment> met;
  for (std::uint32_t node = ordered_list::first(l.storage, list); node != no_node();
       node = ordered_list::next(l.storage, node)) {
    fuzz::law(met.size() < l.nodes.size(), "a list ends");
    met.push_back(l.storage.read_node(node));
  }
  return met;
}

std::vector<fragment> of_list(const std::vector<offer>& offers, std::uint32_t list) {
  std::vector<fragment> all;
  for (const offer& o : offers) {
    if (o.list == list) {
      all.push_back(o.offered);
    }
  }
  return all;
}

/// Offers all; returns those that entered.
template <class Insert>
std::vector<offer> entered(lists& l, const std::vector<offer>& offers, Insert insert) {
  std::vector<offer> in;
  for (const offer& o : offers) {
    const fragment back = insert(l.storage, o.list, o.offered);
    if (!is_fragment(back) && back.depth == no_fragment().depth && is_fragment(o.offered)) {
      in.push_back(o);
    }
  }
  return in;
}

void check_pool(const lists& l, const std::vector<offer>& offers, const std::vector<offer>& in) {
  std::size_t holdable = 0;
  for (const offer& o : offers) {
    holdable += fuzz::sorted({o.offered}).size();
  }
  fuzz::law(in.size() == std::min(holdable, l.nodes.size()), "the pool is used up before anything is refused");
  fuzz::law(l.refused == offers.size() - in.size(), "each refusal is counted once");
  fuzz::law(l.taken <= l.nodes.size() + 1u, "the pool's counter is bounded");
}

void check_sorted_lists(const std::vector<offer>& offers, std::uint32_t capacity) {
  lists l(capacity);
  const auto in = entered(l, offers, [](auto& storage, std::uint32_t list, fragment f) {
    return ordered_list::insert(storage, list, f, ordered_list::unlimited());
  });
  check_pool(l, offers, in);
  for (std::uint32_t list = 0; list < list_count; ++list) {
    fuzz::law(fuzz::equal(walk(l, list), fuzz::sorted(of_list(in, list))), "an ordered list is its fragments, sorted");
  }
}

void check_limit(const std::vector<offer>& offers, std::uint32_t limit) {
  lists l(static_cast<std::uint32_t>(offers.size()));
  entered(l, offers, [limit](auto& storage, std::uint32_t list, fragment f) {
    return ordered_list::insert(storage, list, f, limit);
  });
  for (std::uint32_t list = 0; list < list_count; ++list) {
    std::vector<fragment> nearest = fuzz::sorted(of_list(offers, list));
    std::vector<fragment> met = walk(l, list);
    nearest.resize(std::min<std::size_t>(nearest.size(), limit));
    met.resize(std::min(met.size(), nearest.size()));
    fuzz::law(fuzz::equal(met, nearest), "with a limit, an ordered list begins with the nearest");
  }
}

void check_unsorted_lists(const std::vector<offer>& offers, std::uint32_t capacity) {
  lists l(capacity);
  const auto in = entered(
      l, offers, [](auto& storage, std::uint32_t list, fragment f) { return a_buffer::push(storage, list, f); });
  check_pool(l, offers, in);
  for (std::uint32_t list = 0; list < list_count; ++list) {
    std::vector<fragment> arrived = of_list(in, list);
    std::reverse(arrived.begin(), arrived.end());
    fuzz::law(fuzz::equal(walk(l, list), arrived), "an a_buffer's list is its fragments, last first");
  }
}

/// Blocks of all that comes for one list in a row.
void check_unrolled_lists(const std::vector<offer>& offers, std::uint32_t capacity) {
  lists l(capacity);
  std::vector<fragment> expected[list_count];
  for (std::size_t i = 0; i < offers.size();) {
    const std::uint32_t list = offers[i].list;
    std::vector<fragment> some;
    for (; i < offers.size() && offers[i].list == list; ++i) {
      if (is_fragment(offers[i].offered)) {
        some.push_back(offers[i].offered);
      }
    }
    const auto block = unrolled_list::take(l.storage, static_cast<std::uint32_t>(some.size()));
    some.resize(block.size);
    for (std::uint32_t n = 0; n < block.size; ++n) {
      l.storage.write_node(block.first + n, some[n]);
    }
    unrolled_list::push(l.storage, list, block);
    expected[list].insert(expected[list].begin(), some.begin(), some.end());
  }
  for (std::uint32_t list = 0; list < list_count; ++list) {
    std::vector<fragment> met;
    for (std::uint32_t node = unrolled_list::first(l.storage, list); node != no_node();
         node = unrolled_list::next(l.storage, node)) {
      fuzz::law(met.size() < l.nodes.size(), "an unrolled list ends");
      met.push_back(l.storage.read_node(node));
    }
    fuzz::law(fuzz::equal(met, expected[list]), "an unrolled list is its blocks, last first");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const std::uint32_t capacity = in.below(70u);
  const std::uint32_t limit = 1u + in.below(20u);
  const auto split = in.take<std::uint64_t>();
  std::vector<offer> offers;
  for (const fragment f : fuzz::take_fragments(in, 64)) {
    offers.push_back(offer{static_cast<std::uint32_t>(split >> offers.size() % 64u & 1u), f});
  }
  check_sorted_lists(offers, capacity);
  check_unsorted_lists(offers, capacity);
  check_unrolled_lists(offers, capacity);
  check_limit(offers, limit);
  return 0;
}
