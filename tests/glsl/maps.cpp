// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/atomic_tail.hpp>
#include <pelage/composite/stochastic.hpp>
#include <pelage/core/mixed_bits.hpp>
#include <pelage/visibility/density_clusters.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/occupancy_map.hpp>
#include <pelage/visibility/opacity_map.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "glsl/device.hpp"
#include "glsl/kernels.hpp"
#include "glsl/offers.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

using occupancy = occupancy_map<128, 4>;
constexpr std::uint32_t range_cells = 2;
constexpr std::uint32_t layers = 16;
constexpr std::uint32_t clusters = 4;
constexpr std::uint32_t samples = 16;
constexpr std::uint32_t sums = tail_words();
constexpr std::uint32_t run_time_layers = 40;
constexpr std::uint32_t run_time_cells = layer_sums::texel_cells(run_time_layers);
constexpr std::uint32_t cells_of_texel =
    range_cells + occupancy::cells + layers + density_clusters<clusters>::cells + samples + sums + run_time_cells;

/// All maps of all texels, one kind behind the other as the kernel has them.
struct map_cells {
  std::uint32_t texels;
  std::vector<std::uint32_t> cells;
  std::uint32_t begin = 0;

  /// The cells of the next kind of map.
  atomic_cells<std::uint32_t> next(std::uint32_t cells_a_texel) {
    const atomic_cells<std::uint32_t> part{std::span(cells).subspan(begin, cells_a_texel * texels)};
    begin += cells_a_texel * texels;
    return part;
  }

  explicit map_cells(std::uint32_t n) : texels(n), cells(n * cells_of_texel) {
    const std::uint32_t before = cells_of_texel - samples - sums - run_time_cells;
    std::fill_n(cells.begin() + before * n, samples * n, 0xffffffffU);
  }

  void add(std::uint32_t texel, fragment f) {
    const float share = static_cast<float>(f.id >> 8U) * (1.0F / 16777216.0F);
    const tail one{f.id, f.id >> 4U, f.id >> 8U, f.id >> 12U, f.id & 1U};
    begin = 0;
    atomic_cells<std::uint32_t> ranges = next(range_cells);
    atomic_depth_range::extend(ranges, texel, f.depth);
    atomic_cells<std::uint32_t> occupancies = next(occupancy::cells);
    atomic_occupancy_map::add<occupancy>(occupancies, texel, share * 128.0F, f.id);
    atomic_cells<std::uint32_t> opacities = next(layers);
    atomic_opacity_map::add<opacity_map<layers>>(opacities, texel, share * 16.0F, f.id);
    atomic_cells<std::uint32_t> densities = next(density_clusters<clusters>::cells);
    atomic_density_clusters::add<density_clusters<clusters>>(densities, texel, share * 4.0F);
    atomic_cells<std::uint32_t> stochastic = next(samples);
    atomic_stochastic_depths::add<stochastic_depths<samples>>(stochastic, texel, f, share, 7U);
    atomic_cells<std::uint32_t> tails = next(sums);
    atomic_tail::add(tails, texel, one);
    atomic_cells<std::uint32_t> run_time = next(run_time_cells);
    layer_sums::add(run_time, texel * run_time_cells, run_time_layers, share * 40.0F, f.id);
  }

  /// What loading a texel gives, map after map.
  [[nodiscard]] std::vector<std::uint32_t> loaded(std::uint32_t texel) {
    std::vector<std::uint32_t> all;
    const auto give = [&](const auto& values) { all.insert(all.end(), values.begin(), values.end()); };
    const auto give_tail = [&](const tail& t) { give(std::array{t.optical, t.weight, t.red, t.green, t.blue}); };
    begin = 0;
    const depth_range range = atomic_depth_range::load(next(range_cells), texel);
    give(std::array{range.nearest, range.farthest});
    const auto occupied = atomic_occupancy_map::load<occupancy>(next(occupancy::cells), texel);
    give(occupied.occupied);
    give(occupied.amount);
    give(atomic_opacity_map::load<opacity_map<layers>>(next(layers), texel).amount);
    const auto density =
        atomic_density_clusters::load<density_clusters<clusters>>(next(density_clusters<clusters>::cells), texel);
    give(density.count);
    give(density.sum);
    give(density.squares);
    give(atomic_stochastic_depths::load<stochastic_depths<samples>>(next(samples), texel).nearest);
    give_tail(atomic_tail::load(next(sums), texel));
    atomic_cells<std::uint32_t> run_time = next(run_time_cells);
    const std::uint32_t first = texel * run_time_cells;
    layer_sums::accumulate(run_time, first, run_time_layers);
    for (std::uint32_t i = 0; i < run_time_layers; ++i) {
      const float amount = layer_sums::accumulated_before(run_time, first, run_time_layers, static_cast<float>(i), 0U);
      all.push_back(std::bit_cast<std::uint32_t>(amount));
    }
    return all;
  }
};

}  // namespace

TEST_CASE("Maps that 65536 invocations build at once equal those built one by one, and load as they are") {
  for (const std::uint32_t texels : {4096U, 64U, 1U}) {
    CAPTURE(texels);
    std::vector<fragment> fragments = many(texels, 65536U, 5000U);
    for (fragment& f : fragments)
      f.id = mixed_bits(f.id + texels);
    map_cells expected(texels);
    map_cells built = expected;
    for (std::uint32_t i = 0; i < fragments.size(); ++i)
      expected.add(i % texels, fragments[i]);

    std::vector<std::uint32_t> offers = offers_of(0U, texels, fragments);
    std::vector<std::uint32_t>* const buffers[] = {&offers, &built.cells};
    the_device()->run(kernels::maps, static_cast<std::uint32_t>(fragments.size()), buffers);
    CHECK(built.cells == expected.cells);

    std::vector<std::uint32_t> expected_loaded;
    for (std::uint32_t t = 0; t < texels; ++t) {
      const std::vector<std::uint32_t> one = expected.loaded(t);
      expected_loaded.insert(expected_loaded.end(), one.begin(), one.end());
    }
    std::vector<std::uint32_t> loaded(expected_loaded.size());
    std::vector<std::uint32_t>* const with_result[] = {&offers, &built.cells, &loaded};
    the_device()->run(kernels::loaded_maps, static_cast<std::uint32_t>(fragments.size()), with_result);
    CHECK(loaded == expected_loaded);
  }
}

}  // namespace pelage::test
