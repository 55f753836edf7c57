// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Occupancy and opacity maps over a depth_range: any bits for depths, any amounts, any look-ups.
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/layer_position.hpp>
#include <pelage/visibility/occupancy_batch.hpp>
#include <pelage/visibility/occupancy_map.hpp>
#include <pelage/visibility/opacity_map.hpp>

#include "visibility.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace {

using namespace pelage;
using fuzz::amount_at;
using fuzz::law;

depth_range range_of(const std::vector<amount_at>& all) {
  depth_range range = depth_range::empty();
  for (const amount_at& f : all) {
    range.extend(f.at);
  }
  return range;
}

void check_range(const std::vector<amount_at>& all, const std::vector<float>& look_ups) {
  const depth_range range = range_of(all);
  depth_range merged = depth_range::empty();
  for (std::size_t i = all.size(); i > 0; --i) {
    depth_range one = depth_range::empty();
    one.extend(all[i - 1].at);
    merged.merge(one);
  }
  law(merged.nearest == range.nearest && merged.farthest == range.farthest, "a range depends on no order");
  float before = 0.0f;
  for (const float depth : look_ups) {
    const float at = range.relative(depth);
    law(at >= before && at <= 1.0f, "a relative depth rises in [0, 1]");
    before = at;
  }
  for (const amount_at& f : all) {
    law(!is_finite_depth(f.at) || (f.at >= range.nearest_depth() && f.at <= range.farthest_depth()),
        "a range holds its depths");
  }
}

/// What all maps of sums promise. `layers`: positions run to there. `ends`: at whole multiples of it, sums are exact.
template <class Map>
void check_map(const std::vector<amount_at>& fragments, const std::vector<float>& positions, std::uint32_t layers,
               std::uint32_t ends) {
  const auto filled = [&](std::size_t from, std::size_t to) {
    Map map = Map::empty();
    for (std::size_t i = from; i < to; ++i) {
      map.add(fragments[i].at, fragments[i].amount);
    }
    return map;
  };
  const Map map = filled(0, fragments.size());
  Map merged = filled(fragments.size() / 2, fragments.size());
  merged.merge(filled(0, fragments.size() / 2));
  law(fuzz::same_bits(map, merged), "a map depends on no order");

  const auto total = static_cast<float>(map.total());
  float before = 0.0f;
  for (const float position : positions) {
    const float amount = map.amount_before(position);
    law(amount >= before, "what lies before never falls");
    before = amount;
  }
  law(map.amount_before(0.0f) == 0.0f, "nothing lies before the first layer");
  if (map.total() < 0xffffffffu) {
    law(std::abs(map.amount_before(static_cast<float>(layers)) - total) <= 1e-6f * total, "all lies before the end");
    for (std::uint32_t end = 0; end <= layers; end += ends) {
      double sum = 0.0;
      for (const amount_at& f : fragments) {
        sum += layer_at(f.at, layers) < end ? f.amount : 0.0;
      }
      law(std::abs(static_cast<double>(map.amount_before(static_cast<float>(end))) - sum) <= 1e-6 * sum,
          "ends of layers are exact");
    }
  }
}

template <std::uint32_t Slices, std::uint32_t Slabs>
void check_occupancy(const std::vector<amount_at>& fragments, const std::vector<float>& positions) {
  using map_type = occupancy_map<Slices, Slabs>;
  check_map<map_type>(fragments, positions, Slices, Slices / Slabs);
  map_type map = map_type::empty();
  std::vector<std::uint32_t> cells(map_type::cells, 0u);
  atomic_cells<std::uint32_t> storage{cells};
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    map.add(fragments[i].at, fragments[i].amount);
    const amount_at& other = fragments[fragments.size() - 1 - i];
    atomic_occupancy_map::add<map_type>(storage, 0u, other.at, other.amount);
  }
  law(fuzz::same_bits(map, atomic_occupancy_map::load<map_type>(storage, 0u)), "cells hold the same map");
  std::vector<float> amounts(positions.size());
  amounts_before(map, positions, amounts);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    law(amounts[i] == map.amount_before(positions[i]), "a batch gives what single look-ups give");
  }
}

template <std::uint32_t Layers>
void check_opacity(const std::vector<amount_at>& fragments, const std::vector<float>& positions) {
  check_map<opacity_map<Layers>>(fragments, positions, Layers, 1u);
  auto map = opacity_map<Layers>::empty();
  std::vector<std::uint32_t> cells(Layers, 0u);
  atomic_cells<std::uint32_t> storage{cells};
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    map.add(fragments[i].at, fragments[i].amount);
    const amount_at& other = fragments[fragments.size() - 1 - i];
    atomic_opacity_map::add<opacity_map<Layers>>(storage, 0u, other.at, other.amount);
  }
  law(fuzz::same_bits(map, atomic_opacity_map::load<opacity_map<Layers>>(storage, 0u)), "cells hold the same map");
  auto accumulated = map;
  accumulated.accumulate();
  float before = 0.0f;
  for (const float position : positions) {
    const float amount = accumulated.accumulated_before(position);
    law(amount >= before && amount <= static_cast<float>(map.total()), "an accumulated map rises to its total");
    law(map.total() == 0xffffffffu ||
            std::abs(amount - map.amount_before(position)) <= 1e-5f * static_cast<float>(map.total()),
        "an accumulated map says what the map says");
    before = amount;
  }
}

/// The fragments and look-ups with `position(depth)` for depths.
template <class Position>
std::vector<amount_at> placed(std::vector<amount_at> all, const Position& position) {
  for (amount_at& f : all) {
    f.at = position(f.at);
  }
  return all;
}

template <class Position>
std::vector<float> placed(std::vector<float> all, float most, const Position& position) {
  float before = 0.0f;
  for (float& depth : all) {
    depth = position(depth);
    law(depth >= before && depth <= most, "a position rises in [0, layers]");
    before = depth;
  }
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const auto width = in.take<float>();
  const std::vector<amount_at> all = fuzz::take_amounts(in, 48);
  const std::vector<float> look_ups = fuzz::take_depths(in, 32);
  check_range(all, look_ups);
  const depth_range range = range_of(all);

  const auto slice = [&](float depth) { return slice_position(range.relative(depth), 128u); };
  check_occupancy<128, 4>(placed(all, slice), placed(look_ups, 128.0f, slice));
  check_occupancy<128, 32>(placed(all, slice), placed(look_ups, 128.0f, slice));
  check_opacity<128>(placed(all, slice), placed(look_ups, 128.0f, slice));
  const auto equal = [&](float depth) {
    return equal_layer_position(depth - range.nearest_depth(), std::abs(width), 16u);
  };
  check_opacity<16>(placed(all, equal), placed(look_ups, 16.0f, equal));
  const auto growing = [&](float depth) {
    return growing_layer_position(depth - range.nearest_depth(), std::abs(width), 16u);
  };
  check_opacity<16>(placed(all, growing), placed(look_ups, 16.0f, growing));
  return 0;
}
