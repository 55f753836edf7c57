// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/visibility/opacity_map.hpp>

#include "visibility/map_laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pelage::test {

/// Layers counted at run time, filled by threads as map_laws.hpp asks and read as the opacity_map that they stand for.
template <std::uint32_t Layers>
struct summed {
  using map = opacity_map<Layers>;
  static constexpr std::uint32_t layers = Layers;
  static constexpr std::uint32_t cells = layer_sums::texel_cells(Layers);
  static bool exact_at(std::uint32_t) { return true; }
  static void add(map& m, float position, std::uint32_t amount) { m.add(position, amount); }
  static float before(map m, float position) {
    m.accumulate();
    return m.accumulated_before(position);
  }
  static void add_shared(auto& storage, std::uint32_t texel, float position, std::uint32_t amount) {
    layer_sums::add(storage, texel * cells, Layers, position, amount);
  }
  static map load(const auto& storage, std::uint32_t texel) {
    map m = map::empty();
    const std::uint32_t first = texel * cells;
    for (std::uint32_t i = 0u; i < Layers; ++i)
      m.amount[i] = load_marked(storage, first + i, first + Layers + i / 32u, 1u << (i % 32u));
    return m;
  }
};

TEST_CASE("layers counted at run time keep the laws of a map, sums that end at their range included") {
  check_map_laws<summed<4u>>(1000u);
  check_map_laws<summed<33u>>(1u << 31u);
  check_map_laws<summed<64u>>(1u << 31u);
}

TEST_CASE("seeded: cells that change in two steps lose fragments, and the laws see it") {
  CHECK(lost_by_torn_cells<summed<2u>>() > 0.0);
}

TEST_CASE("accumulated they give the bits of an accumulated opacity_map, and touch no other texel") {
  holds("any fragments, any position", [] {
    constexpr std::uint32_t layers = 33u;
    using described = summed<layers>;
    const std::uint32_t most = *rc::gen::element(1000u, 1u << 31u);
    const std::vector<entry> entries = draw_entries<described>(most);
    cells_of<shaken_cells> storage(3u * described::cells, 0u);
    for (const entry& each : entries)
      described::add_shared(storage, 1u, each.position, each.amount);
    layer_sums::accumulate(storage, described::cells, layers);
    auto map = map_of<described>(entries);
    map.accumulate();
    for (std::uint32_t step = 0u; step <= 4u * layers; ++step) {
      const float position = 0.25f * static_cast<float>(step);
      const std::uint32_t own = *rc::gen::element(0u, 1u, 500u, 0xffffffffu);
      const float found = layer_sums::accumulated_before(storage, described::cells, layers, position, own);
      RC_ASSERT(found == map.accumulated_before_fragment(position, own));
      RC_ASSERT(own > 0u || found == map.accumulated_before(position));
    }
    for (const std::uint32_t texel : {0u, 2u})
      RC_ASSERT(bits(described::load(storage, texel)) == bits(described::map::empty()));
  });
}

TEST_CASE("a fragment is left out of its own layer, and only there") {
  holds("brute force", [] {
    using described = summed<8u>;
    const std::vector<entry> entries = draw_entries<described>(1000u);
    auto map = map_of<described>(entries);
    map.accumulate();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::uint32_t own = layer_at(entries[i].position, 8u);
      double before = 0.0;
      for (std::size_t j = 0; j < entries.size(); ++j) {
        const std::uint32_t layer = layer_at(entries[j].position, 8u);
        const double share = layer < own ? 1.0 : layer == own ? static_cast<double>(entries[i].position) - own : 0.0;
        before += i == j ? 0.0 : share * entries[j].amount;
      }
      const float found = map.accumulated_before_fragment(entries[i].position, entries[i].amount);
      RC_ASSERT(std::abs(static_cast<double>(found) - before) <= 1e-6 * (1.0 + before));
    }
  });
}

}  // namespace pelage::test
