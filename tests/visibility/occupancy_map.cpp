// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/occupancy_batch.hpp>
#include <pelage/visibility/occupancy_map.hpp>

#include "visibility/map_laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace pelage::test {

static_assert(sizeof(occupancy_map<>) + sizeof(depth_range) == 40, "10 MiB for 512 x 512 texels");

template <std::uint32_t Slices, std::uint32_t Slabs>
struct occupancy {
  using map = occupancy_map<Slices, Slabs>;
  static constexpr std::uint32_t layers = Slices;
  static constexpr std::uint32_t cells = map::cells;
  static bool exact_at(std::uint32_t layer) { return layer % (Slices / Slabs) == 0u; }
  static void add(map& m, float position, std::uint32_t amount) { m.add(position, amount); }
  static float before(const map& m, float position) { return m.amount_before(position); }
  static float before_fragment(const map& m, float position) { return m.amount_before_fragment(position); }
  static void add_shared(auto& storage, std::uint32_t texel, float position, std::uint32_t amount) {
    atomic_occupancy_map::add<map>(storage, texel, position, amount);
  }
  static map load(const auto& storage, std::uint32_t texel) { return atomic_occupancy_map::load<map>(storage, texel); }
};

TEST_CASE("128 slices in 4 slabs keep the laws of a map") {
  check_map_laws<occupancy<128u, 4u>>(1000u);
  check_merge<occupancy<128u, 4u>>(1000u);
}

TEST_CASE("they are kept with sums that end at their range") {
  check_map_laws<occupancy<32u, 2u>>(1u << 27u);
  check_merge<occupancy<32u, 2u>>(1u << 27u);
}

TEST_CASE("they are kept with slabs of several words, of parts of one, and of one slice") {
  check_map_laws<occupancy<128u, 1u>>(1u);
  check_map_laws<occupancy<64u, 16u>>(1u);
  check_map_laws<occupancy<32u, 32u>>(1u);
}

TEST_CASE("a fragment of the map does not lie before itself") {
  check_own<occupancy<128u, 4u>>();
  check_own<occupancy<64u, 16u>>();
  check_own<occupancy<32u, 32u>>();
}

TEST_CASE("the paper's order goes across a slice from what lies before the one in front to what lies before it") {
  occupancy_map<> map = occupancy_map<>::empty();
  map.add(3.0f, 1u);
  map.add(9.9f, 1u);
  map.add(128.0f, 1u);
  CHECK(map.interpolated_before_fragment(3.0f) == 0.0f);
  CHECK(map.interpolated_before_fragment(4.25f) == 0.25f);
  CHECK(map.interpolated_before_fragment(9.9f) == 1.0f);
  CHECK(map.interpolated_before_fragment(10.5f) == 1.5f);
  CHECK(map.interpolated_before_fragment(128.0f) == 2.0f);  // itself is not before it
  holds("for any map", [] {
    using described = occupancy<128u, 4u>;
    const auto map = map_of<described>(draw_entries<described>(1000u));
    const auto slice = *rc::gen::inRange<std::uint32_t>(0u, 128u);
    const float inside = *rc::gen::element(0.0f, 0.25f, 0.5f, 0.75f, 1.0f);
    if (slice + 1u < 128u && inside == 1.0f) return;  // the next slice's
    const float from = map.amount_before(slice > 0u ? static_cast<float>(slice - 1u) : 0.0f);
    const float to = map.amount_before(static_cast<float>(slice));
    const float found = map.interpolated_before_fragment(static_cast<float>(slice) + inside);
    const float expected = from + inside * (to - from);
    RC_ASSERT(std::abs(found - expected) <= 1e-5f * expected);
    RC_ASSERT(found <= map.amount_before_fragment(static_cast<float>(slice) + inside));
  });
}

TEST_CASE("Sintorn & Assarsson §3.2: an order worked out by hand") {
  occupancy_map<> map = occupancy_map<>::empty();
  for (const float slice : {1.0f, 1.0f, 5.0f, 32.0f, 40.0f, 40.0f, 40.0f, 50.0f, 63.0f})
    map.add(slice, 1u);
  // Three in the first slab; six in four slices of the second, so that each counts for one and a half.
  CHECK(map.amount_before(5.0f) == 1.5f);
  CHECK(map.amount_before(40.0f) == 4.5f);
  CHECK(map.amount_before(50.0f) == 6.0f);
  CHECK(map.amount_before(63.0f) == 7.5f);
  CHECK(map.interpolated_before_fragment(41.5f) == 5.25f);  // from 4.5 before slice 40 to 6 before slice 41
  CHECK(map.interpolated_before_fragment(33.25f) == 3.375f);
}

TEST_CASE("at a slice's begin the order is the earlier slabs', and the slab's by its share of set slices before") {
  holds("the paper's formula in double", [] {
    using described = occupancy<128u, 4u>;
    const std::vector<entry> entries = draw_entries<described>(1000u);
    const auto map = map_of<described>(entries);
    const auto slice = *rc::gen::inRange<std::uint32_t>(0u, 128u);
    std::array<bool, 128> set{};
    double order = 0.0;
    double of_slab = 0.0;
    for (const entry& each : entries) {
      const std::uint32_t at = std::min(static_cast<std::uint32_t>(each.position), 127u);
      set[at] = true;
      if (at / 32u < slice / 32u) order += each.amount;
      if (at / 32u == slice / 32u) of_slab += each.amount;
    }
    const auto first = set.begin() + slice / 32u * 32u;
    const auto bits = std::count(first, first + 32, true);
    if (bits > 0) {
      order += of_slab / static_cast<double>(bits) * static_cast<double>(std::count(first, set.begin() + slice, true));
    }
    RC_ASSERT(std::abs(map.amount_before(static_cast<float>(slice)) - order) <= 1e-6 * order);
  });
}

TEST_CASE("seeded: cells that change in two steps lose fragments, and the laws see it") {
  CHECK(lost_by_torn_cells<occupancy<32u, 1u>>() > 0.0);
}

template <std::uint32_t Slices, std::uint32_t Slabs>
void check_batch(std::uint32_t most) {
  holds(std::to_string(Slices) + " slices in " + std::to_string(Slabs) + " slabs", [most] {
    using described = occupancy<Slices, Slabs>;
    const auto map = map_of<described>(draw_entries<described>(most));
    std::vector<float> positions(*rc::gen::inRange<std::size_t>(0u, 70u));
    for (float& position : positions) {
      position = static_cast<float>(*rc::gen::inRange<std::uint32_t>(0u, 16u * Slices + 1u)) / 16.0f;
    }
    std::vector<float> amounts(positions.size());
    amounts_before(map, positions, amounts);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      RC_ASSERT(amounts[i] == map.amount_before(positions[i]));
    }
    amounts_before(map, positions, positions);
    RC_ASSERT(positions == amounts);
  });
}

TEST_CASE("batches give the bits of single look-ups, in place too") {
  check_batch<128u, 4u>(1000u);
  check_batch<128u, 4u>(1u << 30u);
  check_batch<128u, 1u>(1u);
  check_batch<64u, 16u>(1u << 20u);
  check_batch<32u, 32u>(1u);
}

TEST_CASE("where no slice holds more than one fragment the order is the truth at every slice") {
  holds("one or none a slice", [] {
    const auto held = *rc::gen::container<std::array<bool, 128>>(rc::gen::arbitrary<bool>());
    occupancy_map<> map = occupancy_map<>::empty();
    for (std::uint32_t i = 0u; i < 128u; ++i) {
      if (held[i]) map.add(static_cast<float>(i) + 0.5f, 1u);
    }
    double truth = 0.0;
    for (std::uint32_t i = 0u; i < 128u; ++i) {
      RC_ASSERT(std::abs(map.amount_before(static_cast<float>(i)) - truth) < 1e-5);
      truth += held[i] ? 1.0 : 0.0;
    }
  });
}

TEST_CASE("an empty slice adds nothing to the order, a set one adds linearly") {
  occupancy_map<> map = occupancy_map<>::empty();
  map.add(3.0f, 1u);
  map.add(9.9f, 1u);
  CHECK(map.amount_before(4.0f) == 1.0f);
  CHECK(map.amount_before(9.0f) == 1.0f);
  CHECK(map.amount_before(9.25f) == 1.25f);
  CHECK(map.amount_before(10.0f) == 2.0f);
  CHECK(map.amount_before(128.0f) == 2.0f);
}

/// RMS difference of the estimated and the true order at every fragment of a clustered pixel.
template <std::uint32_t Slices>
double order_error(const std::vector<float>& sorted) {
  occupancy_map<Slices, 4u> map = occupancy_map<Slices, 4u>::empty();
  for (const float relative : sorted) {
    map.add(slice_position(relative, Slices), 1u);
  }
  double squares = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double difference = map.amount_before(slice_position(sorted[i], Slices)) - static_cast<double>(i);
    squares += difference * difference;
  }
  return std::sqrt(squares / static_cast<double>(sorted.size()));
}

TEST_CASE("the order converges with the number of slices, to within one fragment") {
  std::mt19937 random(7u);
  std::vector<float> sorted;
  for (int i = 0; i < 120; ++i) {
    const float x = static_cast<float>(random() >> 8u) / 16777216.0f;
    sorted.push_back(x * x * x);
  }
  std::sort(sorted.begin(), sorted.end());
  const std::array<double, 4> error = {order_error<32u>(sorted), order_error<128u>(sorted), order_error<1024u>(sorted),
                                       order_error<65536u>(sorted)};
  CHECK(error[1] < error[0]);
  CHECK(error[2] < error[1]);
  CHECK(error[3] < error[2]);
  CHECK(error[3] < 1.0);
}

}  // namespace pelage::test
