// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/visibility/density_clusters.hpp>

#include "visibility/map_laws.hpp"

#include <cmath>
#include <cstdint>

namespace pelage::test {

template <std::uint32_t K>
struct clusters {
  using map = density_clusters<K>;
  static constexpr std::uint32_t layers = K;
  static constexpr std::uint32_t cells = map::cells;
  static bool exact_at(std::uint32_t) { return true; }
  static void add(map& m, float position, std::uint32_t) { m.add(position); }
  static float before(const map& m, float position) { return m.count_before(position); }
  static void add_shared(auto& storage, std::uint32_t texel, float position, std::uint32_t) {
    atomic_density_clusters::add<density_clusters<K>>(storage, texel, position);
  }
  static map load(const auto& storage, std::uint32_t texel) {
    return atomic_density_clusters::load<density_clusters<K>>(storage, texel);
  }
};

TEST_CASE("clusters keep the laws of a map that counts") {
  check_map_laws<clusters<1u>>(1u);
  check_map_laws<clusters<4u>>(1u);
}

TEST_CASE("seeded: cells that change in two steps lose fragments, and the laws see it") {
  CHECK(lost_by_torn_cells<clusters<1u>>() > 0.0);
}

TEST_CASE("fragments at one depth are a step, evenly spread ones a line") {
  density_clusters<1u> step = density_clusters<1u>::empty();
  density_clusters<1u> line = density_clusters<1u>::empty();
  for (int i = 0; i < 512; ++i) {
    step.add(0.5f);
    line.add((static_cast<float>(i) + 0.5f) / 512.0f);
  }
  CHECK(step.count_before(0.5f) == 0.0f);
  CHECK(step.count_before(0.501f) == 512.0f);
  for (const float at : {0.1f, 0.25f, 0.5f, 0.9f}) {
    CHECK(std::abs(line.count_before(at) - 512.0f * at) < 2.0f);
  }
}

TEST_CASE("16,383 fragments at a bin's end are squared and summed, one more is where the sum stops") {
  density_clusters<1u> map = density_clusters<1u>::empty();
  for (std::uint32_t i = 0; i < 16'383u; ++i) {
    map.add(1.0f);
  }
  CHECK(map.squares[0] == 16'383u * 512u * 512u);
  map.add(1.0f);
  CHECK(map.squares[0] == 0xffffffffu);
}

TEST_CASE("a cluster inside its bin is found where it lies") {
  density_clusters<2u> map = density_clusters<2u>::empty();
  for (int i = 0; i < 100; ++i) {
    map.add(1.25f + 0.0025f * static_cast<float>(i));  // [1.25, 1.5]
  }
  CHECK(map.count_before(1.24f) == 0.0f);
  CHECK(std::abs(map.count_before(1.375f) - 50.0f) < 2.0f);
  CHECK(map.count_before(1.51f) == 100.0f);
}

}  // namespace pelage::test
