// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/optical_depth.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/opacity_map.hpp>

#include "visibility/map_laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage::test {

static_assert(sizeof(opacity_map<16u>) + sizeof(depth_range) == 72, "18 MiB for 512 x 512 texels");
static_assert(sizeof(opacity_map<128u>) + sizeof(depth_range) == 520, "130 MiB");

template <std::uint32_t Layers>
struct opacity {
  using map = opacity_map<Layers>;
  static constexpr std::uint32_t layers = Layers;
  static constexpr std::uint32_t cells = Layers;
  static bool exact_at(std::uint32_t) { return true; }
  static void add(map& m, float position, std::uint32_t amount) { m.add(position, amount); }
  static float before(const map& m, float position) { return m.amount_before(position); }
  static float before_fragment(const map& m, float position) { return m.amount_before_fragment(position); }
  static void add_shared(auto& storage, std::uint32_t texel, float position, std::uint32_t amount) {
    atomic_opacity_map::add<opacity_map<Layers>>(storage, texel, position, amount);
  }
  static map load(const auto& storage, std::uint32_t texel) {
    return atomic_opacity_map::load<opacity_map<Layers>>(storage, texel);
  }
};

/// The same after accumulate().
template <std::uint32_t Layers>
struct accumulated : opacity<Layers> {
  static float before(opacity_map<Layers> m, float position) {
    m.accumulate();
    return m.accumulated_before(position);
  }
};

TEST_CASE("opacity maps keep the laws of a map") {
  check_map_laws<opacity<4u>>(1000u);
  check_map_laws<opacity<33u>>(1u);
  check_merge<opacity<4u>>(1000u);
}

TEST_CASE("a fragment of the map does not lie before itself") {
  check_own<opacity<4u>>();
  check_own<opacity<33u>>();
}

TEST_CASE("they are kept with sums of any size but those that end at their range") {
  check_map_laws<opacity<4u>>(1u << 26u);
  check_merge<opacity<4u>>(1u << 30u);
}

TEST_CASE("accumulated maps keep the laws, sums that end at their range included") {
  check_map_laws<accumulated<4u>>(1000u);
  check_map_laws<accumulated<33u>>(1u << 26u);
}

TEST_CASE("seeded: cells that change in two steps lose fragments, and the laws see it") {
  CHECK(lost_by_torn_cells<opacity<2u>>() > 0.0);
}

TEST_CASE("a layer counts by the share of it that lies before") {
  opacity_map<4u> map = opacity_map<4u>::empty();
  map.add(0.5f, 8u);
  map.add(1.0f, 4u);
  map.add(4.0f, 2u);
  CHECK(map.total() == 14u);
  CHECK(map.amount_before(0.25f) == 2.0f);
  CHECK(map.amount_before(1.5f) == 10.0f);
  CHECK(map.amount_before(3.0f) == 12.0f);
  CHECK(map.amount_before(4.0f) == 14.0f);
}

TEST_CASE("no light passes 200 opaque fragments, in one layer or in all") {
  auto map = opacity_map<4u>::empty();
  for (std::uint32_t i = 0u; i < 200u; ++i) {
    map.add(static_cast<float>(i % 4u), optical_depth(1.0f));
  }
  CHECK(transmittance_of(map.amount_before(4.0f)) == 0.0f);  // 6.7e9 units
  CHECK(transmittance_of(map.amount_before(0.0f)) == 1.0f);
  map.accumulate();
  CHECK(transmittance_of(map.accumulated_before(4.0f)) == 0.0f);
}

TEST_CASE("at the end of a layer the sum is exact up to 2^24, and rounded twice a layer by 2^-24 beyond") {
  holds("amounts of any size", [] {
    opacity_map<33u> map = opacity_map<33u>::empty();
    const std::uint32_t most = 1u << *rc::gen::inRange(1u, 27u);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < 33u; ++i) {
      map.amount[i] = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0u, most));
    }
    for (std::uint32_t i = 0; i < 33u; ++i) {
      const double found = map.amount_before(static_cast<float>(i));
      RC_ASSERT(std::abs(found - sum) <= (sum <= 0x1p24 ? 0.0 : 2.0 * i * 0x1p-24 * sum));
      sum += map.amount[i];
    }
    RC_ASSERT(map.amount_before(33.0f) <= sum * (1.0 + 66.0 * 0x1p-24));
  });
}

/// Where layers end, in units of the first one's width; equal or growing.
template <std::size_t Layers>
std::array<double, Layers> layer_ends(bool growing) {
  std::array<double, Layers> ends;
  for (std::size_t i = 0; i < Layers; ++i)
    ends[i] = growing ? 0.5 * static_cast<double>((i + 1) * (i + 2)) : static_cast<double>(i + 1);
  return ends;
}

/// Fragments on a grid that layers' ends lie on, and beyond the last.
struct deep_fragment {
  float offset;
  std::uint32_t amount;
};

std::vector<deep_fragment> draw_deep_fragments(double last_end) {
  std::vector<deep_fragment> all(*rc::gen::inRange<std::size_t>(0u, 41u));
  for (deep_fragment& each : all) {
    each.offset = static_cast<float>(*rc::gen::inRange(0, static_cast<int>(8.0 * last_end) + 20)) / 8.0f;
    each.amount = *rc::gen::inRange(1u, 1000u);
  }
  return all;
}

template <std::uint32_t Layers>
opacity_map<Layers> deep_map(const std::vector<deep_fragment>& all, bool growing) {
  opacity_map<Layers> map = opacity_map<Layers>::empty();
  for (const deep_fragment& each : all) {
    map.add(
        growing ? growing_layer_position(each.offset, 1.0f, Layers) : equal_layer_position(each.offset, 1.0f, Layers),
        each.amount);
  }
  map.accumulate();
  return map;
}

TEST_CASE("Svoboda §1.5.4, §2.7.2: a deep layer has all fragments before its end, the last what lies beyond as well") {
  holds("equal and growing layers", [] {
    const bool growing = *rc::gen::arbitrary<bool>();
    const auto ends = layer_ends<8>(growing);
    const std::vector<deep_fragment> all = draw_deep_fragments(ends.back());
    const auto map = deep_map<8u>(all, growing);
    for (std::size_t i = 0; i < 8u; ++i) {
      std::uint32_t sum = 0u;
      for (const deep_fragment& each : all)
        sum += each.offset < ends[i] || i == 7u ? each.amount : 0u;
      RC_ASSERT(map.amount[i] == sum);
    }
  });
}

TEST_CASE("Svoboda §2.7.3: between layers the look-up is the branch-free sum over all of them") {
  holds("Σ w O in double", [] {
    const bool growing = *rc::gen::arbitrary<bool>();
    const auto ends = layer_ends<8>(growing);
    const auto map = deep_map<8u>(draw_deep_fragments(ends.back()), growing);
    const double z = *rc::gen::inRange(0, 1025) / 1024.0 * ends.back();
    double opacity = 0.0;
    for (std::size_t i = 0; i < 8u; ++i) {
      const double before = ends[i] - (i > 0u ? ends[i - 1u] : 0.0);
      const double behind = i < 7u ? ends[i + 1u] - ends[i] : 1.0;
      const double weight = 1.0 - std::max(0.0, (ends[i] - z) / before) - std::max(0.0, (z - ends[i]) / behind);
      opacity += std::max(0.0, weight) * map.amount[i];
    }
    const float offset = static_cast<float>(z);
    const float position = growing ? growing_layer_position(offset, 1.0f, 8u) : equal_layer_position(offset, 1.0f, 8u);
    RC_ASSERT(std::abs(map.accumulated_before(position) - opacity) <= 2e-5 * map.amount[7]);
  });
}

TEST_CASE("both ways to look up agree to rounding") {
  holds("any map, any position", [] {
    const auto map = map_of<opacity<16u>>(draw_entries<opacity<16u>>(1000u));
    const float position = static_cast<float>(*rc::gen::inRange(0, 16 * 1024 + 1)) / 1024.0f;
    const float direct = map.amount_before(position);
    RC_ASSERT(std::abs(direct - accumulated<16u>::before(map, position)) <= 1e-6f * (1.0f + direct));
  });
}

}  // namespace pelage::test
