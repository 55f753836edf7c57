// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/stochastic.hpp>

#include "property.hpp"
#include "visibility/cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace pelage::test {

struct veil {
  fragment where;
  float alpha;
};

std::vector<veil> draw_veils() {
  std::vector<veil> veils(*rc::gen::inRange<std::size_t>(0u, 20u));
  std::uint32_t id = *rc::gen::arbitrary<std::uint32_t>();
  for (veil& each : veils) {
    each.where = fragment{static_cast<float>(*rc::gen::inRange(0, 16)), id += 0x9e3779b9u};
    each.alpha = static_cast<float>(*rc::gen::inRange(0, 101)) / 100.0f;
  }
  return veils;
}

template <std::uint32_t Samples>
stochastic_depths<Samples> depths_of(const std::vector<veil>& veils, std::uint32_t stream) {
  stochastic_depths<Samples> depths = stochastic_depths<Samples>::empty();
  for (const veil& each : veils) {
    depths.add(each.where, each.alpha, stream);
  }
  return depths;
}

TEST_CASE("any order of fragments and any number of threads give the same bits, the seed others") {
  holds("1 to 8 threads", [](std::uint32_t seed) {
    const std::vector<veil> veils = draw_veils();
    std::vector<veil> shuffled = veils;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(seed));
    const auto expected = depths_of<8u>(veils, stochastic_stream(seed, 1u));
    RC_ASSERT(depths_of<8u>(shuffled, stochastic_stream(seed, 1u)).nearest == expected.nearest);
    for (std::uint32_t threads = 1u; threads <= 8u; threads *= 2u) {
      cells_of<shaken_cells> storage(24u, 0xffffffffu);
      deal_to_threads(threads, veils.size(), [&](std::size_t i) {
        atomic_stochastic_depths::add<stochastic_depths<8u>>(storage, 1u, veils[i].where, veils[i].alpha, seed);
      });
      RC_ASSERT(atomic_stochastic_depths::load<stochastic_depths<8u>>(storage, 1u).nearest == expected.nearest);
      RC_ASSERT(atomic_stochastic_depths::load<stochastic_depths<8u>>(storage, 0u).nearest ==
                stochastic_depths<8u>::empty().nearest);
      RC_ASSERT(atomic_stochastic_depths::load<stochastic_depths<8u>>(storage, 2u).nearest ==
                stochastic_depths<8u>::empty().nearest);
    }
  });
  const std::vector<veil> veils{{fragment{1.0f, 1u}, 0.5f}};
  CHECK(depths_of<64u>(veils, stochastic_stream(1u, 0u)).nearest !=
        depths_of<64u>(veils, stochastic_stream(2u, 0u)).nearest);
  CHECK(depths_of<64u>(veils, stochastic_stream(1u, 0u)).nearest !=
        depths_of<64u>(veils, stochastic_stream(1u, 1u)).nearest);
}

TEST_CASE("the estimate falls from 1 with depth, is 1 before the first and 0 behind an opaque one") {
  holds("any veils", [](std::uint32_t seed) {
    std::vector<veil> veils = draw_veils();
    const auto depths = depths_of<16u>(veils, seed);
    float last = 1.0f;
    RC_ASSERT(depths.transmittance_before(0.0f) == 1.0f);
    for (int depth = 0; depth < 17; ++depth) {
      const float passed = depths.transmittance_before(static_cast<float>(depth));
      RC_ASSERT(passed <= last);
      RC_ASSERT(passed >= 0.0f);
      last = passed;
    }
    veils.push_back(veil{fragment{7.0f, 0u}, 1.0f});
    const auto closed = depths_of<16u>(veils, seed);
    RC_ASSERT(closed.transmittance_before(7.0f) == depths.transmittance_before(7.0f));
    RC_ASSERT(closed.transmittance_before(7.5f) == 0.0f);
  });
}

TEST_CASE("the mean over pixels is the product of transmittances, for neighbouring ids and pixels too") {
  std::vector<veil> veils;
  double truth = 1.0;
  for (std::uint32_t id = 0u; id < 8u; ++id) {
    const float alpha = 0.05f + 0.03f * static_cast<float>(id);
    veils.push_back(veil{fragment{static_cast<float>(id), id}, alpha});
  }
  constexpr std::uint32_t pixels = 20000u;
  std::vector<double> mean(9, 0.0);
  for (std::uint32_t pixel = 0u; pixel < pixels; ++pixel) {
    const auto depths = depths_of<8u>(veils, stochastic_stream(0u, pixel));
    for (std::size_t i = 0; i <= 8u; ++i) {
      mean[i] += depths.transmittance_before(static_cast<float>(i)) / double{pixels};
    }
  }
  for (std::size_t i = 0; i <= 8u; ++i) {
    CHECK(std::abs(mean[i] - truth) < 5.0 * 0.5 / std::sqrt(8.0 * pixels));  // five standard deviations at most
    truth *= i < 8u ? 1.0 - veils[i].alpha : 1.0;
  }
}

TEST_CASE("alpha 0 takes no sample, 1 takes all, and what is no fragment changes nothing") {
  const auto none = stochastic_depths<64u>::empty();
  CHECK(depths_of<64u>({{fragment{1.0f, 3u}, 0.0f}}, 9u).nearest == none.nearest);
  CHECK(depths_of<64u>({{no_fragment(), 1.0f}}, 9u).nearest == none.nearest);
  CHECK(depths_of<64u>({{fragment{std::numeric_limits<float>::quiet_NaN(), 3u}, 1.0f}}, 9u).nearest == none.nearest);
  CHECK(depths_of<64u>({{fragment{1.0f, 3u}, 1.0f}}, 9u).transmittance_before(2.0f) == 0.0f);
}

}  // namespace pelage::test
