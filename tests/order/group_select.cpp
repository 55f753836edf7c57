// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/group_select.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "order/lane_fibers.hpp"
#include "order/oracle.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

/// A list, how it is selected from, and by how many lanes.
struct selection {
  std::vector<fragment> list;
  std::uint32_t k;
  std::uint32_t lanes;
  bool two_passes;
  std::uint32_t at;  ///< a slot that all lanes ask for
};

/// What the lanes end with.
struct outcome {
  std::vector<placed_fragment> slots;
  std::vector<std::uint32_t> held;   ///< by lane
  std::vector<placed_fragment> at;   ///< by lane
  std::vector<std::uint8_t> behind;  ///< by fragment
  std::string fault;
};

template <std::uint32_t Rows, class Group>
void select_in_lane(Group& group, const selection& s, outcome& out) {
  group_select<Rows> nearest;
  nearest.clear(s.k);
  const auto n = static_cast<std::uint32_t>(s.list.size());
  if (s.two_passes) {
    for (std::uint32_t i = group.lane(); i < n; i += group.size())
      nearest.offer_depth(s.list[i]);
    nearest.limit(group);
  }
  for (std::uint32_t from = 0; from < n; from += group.size()) {
    const std::uint32_t i = from + group.lane();
    nearest.insert(group, i < n ? s.list[i] : no_fragment(), i);
  }
  nearest.finish(group);
  for (std::uint32_t row = 0; row < Rows; ++row)
    out.slots[row * group.size() + group.lane()] = nearest.slot[row];
  out.held[group.lane()] = nearest.held(group);
  out.at[group.lane()] = nearest.at(group, s.at);
  for (std::uint32_t i = group.lane(); i < n; i += group.size())
    out.behind[i] = nearest.is_behind(s.list[i]) ? 1 : 0;
}

template <std::uint32_t Rows>
outcome select_with(const selection& s) {
  outcome out{std::vector<placed_fragment>(Rows * s.lanes),
              std::vector<std::uint32_t>(s.lanes),
              std::vector<placed_fragment>(s.lanes),
              std::vector<std::uint8_t>(s.list.size()),
              {}};
  if (s.lanes == 1) {
    std::vector<std::uint32_t> words(6);
    subgroup alone{words};
    select_in_lane<Rows>(alone, s, out);
  } else {
    out.fault = lane_fibers(s.lanes, 6 * s.lanes).run([&](auto& group) { select_in_lane<Rows>(group, s, out); });
  }
  return out;
}

outcome select(const selection& s) {
  const std::uint32_t rows = (s.k + s.lanes - 1) / s.lanes;
  if (rows > 16) return select_with<64>(s);
  if (rows > 4) return select_with<16>(s);
  if (rows > 2) return select_with<4>(s);
  return rows == 2 ? select_with<2>(s) : select_with<1>(s);
}

/// Thousands of fragments, of few depths or many; whether no id comes twice.
std::vector<fragment> long_list(bool unique) {
  const auto n = *rc::gen::inRange<std::uint32_t>(0, 5000);
  const auto depths = *rc::gen::element<std::uint32_t>(1, 7, 1000, 0xffffffffU);
  const auto ids = unique ? n + 1 : *rc::gen::element<std::uint32_t>(1, 3, 1000);
  std::uint32_t state = *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>());
  std::vector<fragment> all;
  for (std::uint32_t i = 0; i < n; ++i) {
    state = state * 1664525U + 1013904223U;
    const std::uint32_t drawn = (state >> 8U) * 0x9e3779b9U;
    all.push_back({depths == 0xffffffffU ? std::bit_cast<float>(drawn) : static_cast<float>(drawn % depths), i % ids});
  }
  return all;
}

selection any_selection(bool unique) {
  selection s;
  s.list = *rc::gen::arbitrary<bool>() ? *any_fragments() : long_list(unique);
  s.k = *rc::gen::inRange(1U, 65U);
  s.lanes = *rc::gen::element(1U, 2U, 4U, 8U, 16U, 32U, 64U);
  s.two_passes = *rc::gen::arbitrary<bool>();
  s.at = *rc::gen::inRange(0U, s.k);
  return s;
}

bool is(placed_fragment held, fragment f) {
  return depth_from_key(held.key) == f.depth && held.id == f.id;  // -0 is +0
}

bool is_none(placed_fragment held) {
  return held.key == 0xffffffffU && held.id == 0xffffffffU;
}

}  // namespace

TEST_CASE("A group's slots are the K first of all fragments sorted, each held once") {
  holds("by groups of 1 to 64 lanes, equal fragments among them, in one pass and in two", [] {
    const selection s = any_selection(*rc::gen::arbitrary<bool>());
    const outcome out = select(s);
    RC_ASSERT(out.fault == "");
    const std::vector<fragment> sorted = in_order(s.list);
    const std::size_t held = std::min<std::size_t>(s.k, sorted.size());
    std::set<std::uint32_t> places;
    for (std::size_t i = 0; i < s.k; ++i) {
      if (i >= held) {
        RC_ASSERT(is_none(out.slots[i]));
        continue;
      }
      RC_ASSERT(is(out.slots[i], sorted[i]));
      RC_ASSERT(is(out.slots[i], s.list.at(out.slots[i].place)));
      RC_ASSERT(places.insert(out.slots[i].place).second);
    }
    for (std::uint32_t lane = 0; lane < s.lanes; ++lane) {
      RC_ASSERT(out.held[lane] == held);
      RC_ASSERT((s.at < held ? is(out.at[lane], sorted[s.at]) : is_none(out.at[lane])));
    }
  });
}

TEST_CASE("What lies behind a group's slots is all that they do not hold") {
  holds("where ids are unique", [] {
    const selection s = any_selection(true);
    const outcome out = select(s);
    std::vector<fragment> behind;
    for (std::size_t i = 0; i < s.list.size(); ++i) {
      if (out.behind[i] != 0) behind.push_back(s.list[i]);
    }
    std::vector<fragment> rest = in_order(s.list);
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(s.k, rest.size())));
    RC_ASSERT(bits(in_order(behind)) == bits(rest));
    RC_ASSERT(behind.size() == rest.size());
  });
}

TEST_CASE("Every barrier of the selection is needed: without any one of them, two lanes race") {
  std::vector<fragment> list;  // with some that are refused, so that no lane finds in its place what it stored itself
  for (std::uint32_t i = 0; i < 100; ++i)
    list.push_back(i % 5 == 0 ? no_fragment() : fragment{static_cast<float>(i * 37 % 101), i});
  const selection s{list, 12, 8, false, 0};
  outcome out{std::vector<placed_fragment>(16),
              std::vector<std::uint32_t>(8),
              std::vector<placed_fragment>(8),
              std::vector<std::uint8_t>(100),
              {}};
  lane_fibers once(8, 48);
  CHECK(once.run([&](auto& group) { select_in_lane<2>(group, s, out); }) == "");
  REQUIRE(once.barriers() >= 6);
  for (std::uint32_t missing = 0; missing < once.barriers(); ++missing) {
    CAPTURE(missing);
    lane_fibers twice(8, 48, missing);
    const std::string fault = twice.run([&](auto& group) {
      select_in_lane<2>(group, s, out);
      select_in_lane<2>(group, s, out);
    });
    CHECK(fault == "a race");
  }
}

TEST_CASE("A call that one lane leaves out is found") {
  const auto fault = [](auto body) { return lane_fibers(4, 4).run(body); };
  CHECK(fault([](auto& group) {
          if (group.lane() != 2) (void)group.count(true);
        }) == "some lanes have ended, others call the group");
  CHECK(fault([](auto& group) { (void)(group.lane() == 2 ? group.count(true).all : group.shuffle(0, 0)); }) ==
        "lanes make different calls");
}

}  // namespace pelage::test
