// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/atomic_cells.hpp>

#include "property.hpp"
#include "visibility/cells.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

/// The laws that every map of layers keeps. A map under test is described by a struct with: map, layers (its greatest
/// position), cells (a texel), exact_at(layer) (whether its answer is exact at that layer's begin), add(map, position,
/// amount), before(map, position), and for check_own() before_fragment(map, position), add_shared(storage, texel,
/// position, amount), load(storage, texel).
namespace pelage::test {

struct entry {
  float position;
  std::uint32_t amount;
};

/// Up to 40 fragments at positions in [0, layers], often on a layer's end; amounts in [1, most].
template <class Described>
std::vector<entry> draw_entries(std::uint32_t most) {
  std::vector<entry> entries(*rc::gen::inRange<std::size_t>(0u, 41u));
  for (entry& each : entries) {
    each.position = static_cast<float>(*rc::gen::inRange<std::uint32_t>(0u, 8u * Described::layers + 1u)) / 8.0f;
    each.amount = *rc::gen::inRange<std::uint32_t>(1u, most + 1u);
  }
  return entries;
}

template <class Described>
typename Described::map map_of(const std::vector<entry>& entries) {
  typename Described::map map = Described::map::empty();
  for (const entry& each : entries) {
    Described::add(map, each.position, each.amount);
  }
  return map;
}

template <class Map>
auto bits(const Map& map) {
  return std::bit_cast<std::array<std::uint32_t, sizeof(Map) / 4u>>(map);
}

/// What truly lies before a layer: a fragment at its begin lies in it, one at the map's end in the last.
template <class Described>
double truly_before(const std::vector<entry>& entries, std::uint32_t layer) {
  double sum = 0.0;
  for (const entry& each : entries) {
    const float held = std::min(each.position, static_cast<float>(Described::layers) - 0.5f);
    sum += held < static_cast<float>(layer) ? each.amount : 0.0;
  }
  return sum;
}

template <class Described>
void check_map_laws(std::uint32_t most) {
  holds("never falls, from 0 to the total", [most] {
    const std::vector<entry> entries = draw_entries<Described>(most);
    const auto map = map_of<Described>(entries);
    const std::uint32_t steps = 32u * Described::layers;
    const float a = static_cast<float>(*rc::gen::inRange<std::uint32_t>(0u, steps + 1u)) / 32.0f;
    const float b = static_cast<float>(*rc::gen::inRange<std::uint32_t>(0u, steps + 1u)) / 32.0f;
    const float end = static_cast<float>(Described::layers);
    RC_ASSERT(Described::before(map, 0.0f) == 0.0f);
    RC_ASSERT(Described::before(map, std::min(a, b)) <= Described::before(map, std::max(a, b)));
    RC_ASSERT(Described::before(map, a) >= 0.0f);
    RC_ASSERT(Described::before(map, a) <= Described::before(map, end));
    const double total = std::min(truly_before<Described>(entries, Described::layers), 4294967295.0);
    RC_ASSERT(Described::before(map, end) >= total * (1.0 - 1e-6));
    RC_ASSERT(Described::before(map, end) <= total * (1.0 + 1e-6));
  });
  holds("exact at the ends", [most] {
    const std::vector<entry> entries =
        draw_entries<Described>(std::min(most, 1000u));  // sums below 2^24: exact in a float
    const auto map = map_of<Described>(entries);
    for (std::uint32_t layer = 0u; layer <= Described::layers; ++layer) {
      if (!Described::exact_at(layer)) continue;
      RC_ASSERT(Described::before(map, static_cast<float>(layer)) == truly_before<Described>(entries, layer));
    }
  });
  holds("the same bits in any order", [most] {
    const std::vector<entry> entries = draw_entries<Described>(most);
    std::vector<entry> shuffled = entries;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    RC_ASSERT(bits(map_of<Described>(shuffled)) == bits(map_of<Described>(entries)));
  });
  holds("the same bits from 1 to 8 threads, and no other texel touched", [most] {
    const std::vector<entry> entries = draw_entries<Described>(most);
    for (std::uint32_t threads = 1u; threads <= 8u; threads *= 2u) {
      cells_of<shaken_cells> storage(3u * Described::cells, 0u);
      deal_to_threads(threads, entries.size(), [&](std::size_t i) {
        Described::add_shared(storage, 1u, entries[i].position, entries[i].amount);
      });
      RC_ASSERT(bits(Described::load(storage, 1u)) == bits(map_of<Described>(entries)));
      RC_ASSERT(bits(Described::load(storage, 0u)) == bits(Described::map::empty()));
      RC_ASSERT(bits(Described::load(storage, 2u)) == bits(Described::map::empty()));
    }
  });
}

template <class Described>
void check_own() {
  holds("a fragment of the map is not among those before itself, the farthest neither", [] {
    const std::vector<entry> entries = draw_entries<Described>(1000u);
    const auto map = map_of<Described>(entries);
    const auto layer = [](const entry& e) { return layer_at(e.position, Described::layers); };
    for (const entry& each : entries) {
      const double truth = truly_before<Described>(entries, layer(each));
      const float found = Described::before_fragment(map, each.position);
      RC_ASSERT((found == 0.0f) == (truth == 0.0));
      RC_ASSERT(found < truly_before<Described>(entries, Described::layers));
      RC_ASSERT(!Described::exact_at(layer(each)) || found == truth);
    }
  });
  holds("with one fragment a layer it is their order", [] {
    const auto held = *rc::gen::container<std::array<bool, Described::layers>>(rc::gen::arbitrary<bool>());
    std::vector<entry> entries;
    for (std::uint32_t i = 0u; i < Described::layers; ++i) {
      const float inside = *rc::gen::element(0.0f, 0.5f, i + 1u == Described::layers ? 1.0f : 0.75f);
      if (held[i]) entries.push_back({static_cast<float>(i) + inside, 1u});
    }
    const auto map = map_of<Described>(entries);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      RC_ASSERT(std::abs(Described::before_fragment(map, entries[i].position) - static_cast<float>(i)) < 1e-5f);
    }
  });
}

template <class Described>
void check_merge(std::uint32_t most) {
  holds("a merge is the map of both", [most] {
    const std::vector<entry> entries = draw_entries<Described>(most);
    const auto middle = entries.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(entries) + 1);
    auto merged = map_of<Described>({middle, entries.end()});
    merged.merge(map_of<Described>({entries.begin(), middle}));
    RC_ASSERT(bits(merged) == bits(map_of<Described>(entries)));
  });
}

/// What a single texel loses to cells that change in two steps, of 4,000 fragments from 8 threads; 0: nothing.
template <class Described>
double lost_by_torn_cells() {
  double lost = 0.0;
  for (int attempt = 0; attempt < 20 && lost == 0.0; ++attempt) {
    cells_of<torn_cells> storage(Described::cells, 0u);
    deal_to_threads(8u, 4000u, [&](std::size_t) { Described::add_shared(storage, 0u, 0.25f, 1u); });
    lost = 4000.0 - Described::before(Described::load(storage, 0u), static_cast<float>(Described::layers));
  }
  return lost;
}

}  // namespace pelage::test
