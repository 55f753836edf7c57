// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/ordered_list.hpp>
#include <pelage/order/unrolled_list.hpp>

#include <algorithm>
#include <bit>
#include <vector>

#include "glsl/comparison.hpp"
#include "glsl/kernels.hpp"
#include "glsl/offers.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

constexpr std::size_t offered = 24;  ///< fragments for each invocation, as in the kernel

void put(results& out, fragment f) {
  out.put(f.depth);
  out.put(f.id);
}

template <std::uint32_t K>
void k_buffer_row(row in, results& out) {
  k_buffer<K> near = k_buffer<K>::empty();
  k_buffer<K> rest = k_buffer<K>::empty();
  k_buffer<5> nearest = k_buffer<5>::empty();
  for (std::size_t i = 0; i < offered; ++i) {
    const fragment f{in.f(2 * i), in.u(2 * i + 1)};
    put(out, i % 3 == 2 ? rest.insert(f) : near.insert(f));
    (void)nearest.insert(f);
  }
  near.merge(rest);
  near.sort();
  nearest.sort();
  for (const fragment& f : near.slot)
    put(out, f);
  out.put(near.size());
  out.put(near.farthest_slot);
  out.put(rest.size());
  for (const fragment& f : nearest.slot)
    put(out, f);
}

template <std::uint32_t K>
void k_buffer_holds(const kernel& k) {
  std::vector<rc::Gen<std::uint32_t>> inputs;
  for (std::size_t i = 0; i < offered; ++i) {
    inputs.push_back(rc::gen::weightedOneOf<std::uint32_t>({{3, between(1.0F, 100.0F)}, {1, any_float()}}));
    inputs.push_back(rc::gen::weightedOneOf<std::uint32_t>({{3, few_words()}, {1, any_word()}}));
  }
  // Depths are copied, never computed: NaN keeps its bits or becomes another NaN, all else must be equal.
  std::vector<column> columns;
  const auto fragments = [&](std::size_t n, const char* what) {
    for (std::size_t i = 0; i < n; ++i) {
      columns.push_back({what, 1, 0, 0});
      columns.push_back({what, 1, bits(), bits()});
    }
  };
  fragments(offered, "k_buffer insert");
  fragments(K, "k_buffer merge and sort");
  columns.push_back({"k_buffer size, farthest", 3, bits(), bits()});
  fragments(5, "k_buffer sort, K = 5");
  compare(k, inputs, k_buffer_row<K>, columns);
}

/// The lists of one frame as the kernels bind them.
struct frame {
  std::vector<std::uint32_t> offers;  ///< limit, lists, then depth and id of each fragment
  std::vector<std::uint32_t> links;
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint32_t> counters{0U, 0U};  ///< taken, refused

  frame(std::uint32_t lists, std::uint32_t capacity, std::uint32_t limit, const std::vector<fragment>& fragments)
      : offers(offers_of(limit, lists, fragments)),
        links(lists + capacity, no_node()),
        nodes(2 * static_cast<std::size_t>(capacity)) {}

  void run(const kernel& k) {
    std::vector<std::uint32_t>* const buffers[] = {&offers, &links, &nodes, &counters};
    the_device()->run(k, static_cast<std::uint32_t>(offers.size() / 2 - 1), buffers);
  }

  [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> list(std::uint32_t l) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    const std::size_t lists = links.size() - nodes.size() / 2;
    for (std::uint32_t n = links[l]; n != no_node() && all.size() <= nodes.size(); n = links[lists + n]) {
      all.emplace_back(nodes[2 * static_cast<std::size_t>(n)], nodes[2 * static_cast<std::size_t>(n) + 1]);
    }
    return all;
  }
};

/// The same inserts one after another on the CPU.
template <typename Insert>
frame sequential(frame f, std::uint32_t lists, const std::vector<fragment>& fragments, Insert insert) {
  std::vector<fragment> nodes(f.nodes.size() / 2);
  atomic_list_storage storage{f.links, nodes, f.counters.data(), f.counters.data() + 1};
  for (std::uint32_t i = 0; i < fragments.size(); ++i)
    insert(storage, i % lists, fragments[i]);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    f.nodes[2 * i] = std::bit_cast<std::uint32_t>(nodes[i].depth);
    f.nodes[2 * i + 1] = nodes[i].id;
  }
  return f;
}

}  // namespace

TEST_CASE("A K-buffer ends in the same bits on every device, two sizes in one shader too") {
  holds("K = 16", [] { k_buffer_holds<16>(kernels::k_buffer_16); });
  holds("K = 8", [] { k_buffer_holds<8>(kernels::k_buffer_8); });
}

TEST_CASE("Ordered lists that 65536 invocations build at once equal those built one by one") {
  for (const std::uint32_t lists : {4096U, 64U, 1U}) {
    CAPTURE(lists);
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
      CAPTURE(seed);
      const std::uint32_t count = lists == 1U ? 4096U : 65536U;
      const std::vector<fragment> fragments = many(seed, count, 5000U);
      frame built(lists, count, ordered_list::unlimited(), fragments);
      const frame expected = sequential(built, lists, fragments, [](auto& storage, std::uint32_t list, fragment f) {
        (void)ordered_list::insert(storage, list, f, ordered_list::unlimited());
      });
      built.run(kernels::ordered_list);
      CHECK(built.counters == expected.counters);
      bool equal = true;
      for (std::uint32_t l = 0; l < lists; ++l)
        equal = equal && built.list(l) == expected.list(l);
      CHECK(equal);
    }
  }
}

TEST_CASE("The first nodes of limited ordered lists are the nearest, whatever the interleaving") {
  const std::uint32_t lists = 512U;
  const std::uint32_t limit = 16U;
  const std::vector<fragment> fragments = many(7U, 65536U, 100000U);
  frame built(lists, 65536U, limit, fragments);
  const frame expected = sequential(built, lists, fragments, [](auto& storage, std::uint32_t list, fragment f) {
    (void)ordered_list::insert(storage, list, f, ordered_list::unlimited());
  });
  built.run(kernels::ordered_list);
  bool equal = true;
  for (std::uint32_t l = 0; l < lists; ++l) {
    auto near = built.list(l);
    auto all = expected.list(l);
    REQUIRE(near.size() >= limit);
    near.resize(limit);
    all.resize(limit);
    equal = equal && near == all;
  }
  CHECK(equal);
}

TEST_CASE("A full pool keeps every ordered list intact and counts what it refuses") {
  const std::uint32_t lists = 256U;
  const std::uint32_t capacity = 20000U;
  const std::vector<fragment> fragments = many(11U, 65536U, 3000U);
  frame built(lists, capacity, ordered_list::unlimited(), fragments);
  built.run(kernels::ordered_list);
  CHECK(built.counters[1] == 65536U - capacity);
  std::vector<std::uint32_t> seen;
  for (std::uint32_t l = 0; l < lists; ++l) {
    const auto list = built.list(l);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const fragment f{std::bit_cast<float>(list[i].first), list[i].second};
      CHECK(f.id % lists == l);
      CHECK(same(f, fragments[f.id]));
      if (i > 0) CHECK(before(fragment{std::bit_cast<float>(list[i - 1].first), list[i - 1].second}, f));
      seen.push_back(f.id);
    }
  }
  std::sort(seen.begin(), seen.end());
  CHECK(seen.size() == capacity);
  CHECK(std::unique(seen.begin(), seen.end()) == seen.end());
}

TEST_CASE("Unsorted lists that 65536 invocations build at once hold the same fragments as those built one by one") {
  for (const std::uint32_t lists : {4096U, 64U, 1U}) {
    CAPTURE(lists);
    const std::vector<fragment> fragments = many(lists, 65536U, 1000U);
    frame built(lists, 65536U, 0U, fragments);
    const frame expected = sequential(built, lists, fragments, [](auto& storage, std::uint32_t list, fragment f) {
      (void)a_buffer::push(storage, list, f);
    });
    built.run(kernels::a_buffer);
    CHECK(built.counters == expected.counters);
    bool equal = true;
    for (std::uint32_t l = 0; l < lists; ++l) {
      auto got = built.list(l);
      auto wanted = expected.list(l);
      std::sort(got.begin(), got.end());
      std::sort(wanted.begin(), wanted.end());
      equal = equal && got == wanted;
    }
    CHECK(equal);
  }
}

TEST_CASE("A full pool keeps every unsorted list intact and counts what it refuses") {
  const std::vector<fragment> fragments = many(3U, 65536U, 1000U);
  frame built(128U, 10000U, 0U, fragments);
  built.run(kernels::a_buffer);
  CHECK(built.counters[1] == 65536U - 10000U);
  std::size_t held = 0;
  for (std::uint32_t l = 0; l < 128U; ++l)
    held += built.list(l).size();
  CHECK(held == 10000U);
}

/// Runs a kernel on lists of blocks and what a reader finds of each, `each` words.
std::vector<std::uint32_t> run_on_blocks(frame& built, const kernel& k, std::uint32_t invocations, std::size_t each) {
  std::vector<std::uint32_t> places(each * built.offers[1], no_node());
  std::vector<std::uint32_t>* const buffers[] = {&built.offers, &built.links, &built.nodes, &built.counters, &places};
  the_device()->run(k, invocations, buffers);
  return places;
}

/// The nodes of a list of blocks.
std::vector<std::uint32_t> nodes_of(frame& built, std::uint32_t list) {
  std::vector<fragment> unread(built.nodes.size() / 2);
  const atomic_list_storage storage{built.links, unread, &built.counters[0], &built.counters[1]};
  std::vector<std::uint32_t> nodes;
  std::uint32_t n = unrolled_list::first(storage, list);
  for (; n != no_node() && nodes.size() <= unread.size(); n = unrolled_list::next(storage, n))
    nodes.push_back(n);
  return nodes;
}

TEST_CASE("Lists of blocks that many invocations build at once hold what was pushed, and subgroups read them whole") {
  for (const std::uint32_t lists : {4096U, 64U, 1U}) {
    for (const std::uint32_t capacity : {30000U, 10000U}) {
      CAPTURE(lists);
      CAPTURE(capacity);
      const std::vector<fragment> fragments = many(lists, 30000U, 1000U);
      frame built(lists, capacity, 0U, fragments);
      (void)run_on_blocks(built, kernels::unrolled_list, 30000U + 5U * lists, 1);
      CHECK(built.counters[1] == 30000U - capacity);
      std::vector<std::uint32_t> seen;
      std::vector<std::vector<std::uint32_t>> nodes;
      for (std::uint32_t l = 0; l < lists; ++l) {
        nodes.push_back(nodes_of(built, l));
        for (const std::uint32_t n : nodes.back()) {
          const std::uint32_t id = built.nodes[2 * std::size_t{n} + 1];
          REQUIRE(id % lists == l);
          seen.push_back(id);
        }
      }
      std::sort(seen.begin(), seen.end());
      CHECK(seen.size() == capacity);
      CHECK(std::unique(seen.begin(), seen.end()) == seen.end());

      const std::size_t each = 30000U / lists + 1;
      const std::vector<std::uint32_t> places =
          run_on_blocks(built, kernels::unrolled_list_read, lists * the_device()->subgroup(), each);
      bool equal = true;
      for (std::uint32_t l = 0; l < lists; ++l) {
        const auto first = places.begin() + static_cast<std::ptrdiff_t>(each * l);
        equal = equal && std::equal(nodes[l].begin(), nodes[l].end(), first);
      }
      CHECK(equal);
    }
  }
}

}  // namespace pelage::test
