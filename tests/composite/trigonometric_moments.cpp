// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/trigonometric_moments.hpp>

#include "composite/moment_oracle.hpp"
#include "property.hpp"
#include "visibility/cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace pelage::test {

static_assert(sizeof(trigonometric_moments<2>) == 20 && sizeof(trigonometric_moments<3>) == 28);

template <std::uint32_t N>
trigonometric_moments<N> moments_of(const std::vector<absorber>& all) {
  auto moments = trigonometric_moments<N>::empty();
  for (const absorber& each : all) {
    moments.add(each.relative, each.amount);
  }
  return moments;
}

template <class Check>
void for_both_orders(const Check& check) {
  check.template operator()<2>();
  check.template operator()<3>();
}

TEST_CASE("any order of fragments, any split into parts and any number of threads give the same bits") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      const std::vector<absorber> all = draw_absorbers(0u, 60u);
      std::vector<absorber> shuffled = all;
      std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
      const auto cut = static_cast<std::ptrdiff_t>(*rc::gen::inRange<std::size_t>(0u, all.size() + 1u));
      auto parts = moments_of<N>({shuffled.begin(), shuffled.begin() + cut});
      parts.merge(moments_of<N>({shuffled.begin() + cut, shuffled.end()}));
      RC_ASSERT(parts.sum == moments_of<N>(all).sum);
      for (std::uint32_t threads = 1u; threads <= 4u; threads *= 2u) {
        using moments = trigonometric_moments<N>;
        cells_of<shaken_cells> cells(3u * moments::cells, 0u);
        deal_to_threads(threads, all.size(), [&](std::size_t i) {
          atomic_trigonometric_moments::add(cells, 1u, moments::of(shuffled[i].relative, shuffled[i].amount));
        });
        RC_ASSERT(atomic_trigonometric_moments::load<moments>(cells, 1u).sum == parts.sum);
        RC_ASSERT(atomic_trigonometric_moments::load<moments>(cells, 0u).sum == moments::empty().sum);
        RC_ASSERT(atomic_trigonometric_moments::load<moments>(cells, 2u).sum == moments::empty().sum);
      }
    });
  });
}

TEST_CASE("each sum is rounded by a unit a fragment and by the last digits of a float") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      const std::vector<absorber> all = draw_absorbers(1u, 60u);
      const auto moments = moments_of<N>(all);
      for (std::uint32_t k = 1u; k <= N; ++k) {
        long double along = 0.0L;
        long double across = 0.0L;
        long double amounts = 0.0L;
        for (const absorber& each : all) {
          const long double angle = k * 0.9L * std::numbers::pi_v<long double> * position_of(each);
          along += each.amount * (1.0L + std::cos(angle)) / 2.0L;
          across += each.amount * (1.0L + std::sin(angle)) / 2.0L;
          amounts += each.amount;
        }
        const auto bound = static_cast<long double>(all.size()) + 2e-6L * amounts;
        RC_ASSERT(std::abs(along - moments.sum[2u * k - 1u]) <= bound);
        RC_ASSERT(std::abs(across - moments.sum[2u * k]) <= bound);
      }
    });
  });
}

TEST_CASE("the node at a depth holds as much as any distribution with these moments can have there") {
  for_both_orders([]<std::uint32_t N>() {
    holds("at each fragment of N = " + std::to_string(N), [] {
      const std::vector<absorber> all = draw_absorbers(1u, 40u);
      const auto told = moments_of<N>(all).visibility();
      for (const absorber& each : all) {
        if (each.relative <= 0.0f) continue;
        const moment_bounds interval = told.interval_before(each.relative);
        double here = 0.0;
        for (const absorber& other : all)
          here += other.relative == each.relative ? other.amount : 0.0;
        RC_ASSERT(double{interval.most} - double{interval.least} > (1.0 - 1e-4) * here - 1e-5 * told.amount - 16.0);
        RC_ASSERT((interval.least >= 0.0f && double{interval.most} <= 1.000001 * told.amount));
      }
    });
  });
}

TEST_CASE("one fragment has nothing before it, two and as many as N that are not near to each other are told apart") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      const auto amount = [] { return optical_depth(0.05f + 0.9f * draw_share()); };
      std::vector<absorber> all{{0.0f, amount()}};
      RC_ASSERT(moments_of<N>(all).visibility().amount_before_fragment(0.0f, all[0].amount) == 0.0f);
      all.push_back({1.0f, amount()});
      if (N == 3u && *rc::gen::arbitrary<bool>()) all.push_back({0.2f + 0.6f * draw_share(), amount()});
      const auto told = moments_of<N>(all).visibility();
      for (const absorber& each : all) {
        const float before = told.amount_before_fragment(each.relative, each.amount);
        RC_ASSERT(std::abs(passed(before) - passed(amount_before(all, each.relative))) <
                  (all.size() > 2u ? 1e-2 : 1e-4));
      }
    });
  });
}

TEST_CASE("nothing, NaN and opaque fragments have a defined place") {
  for_both_orders([]<std::uint32_t N>() {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    using moments = trigonometric_moments<N>;
    for (const float relative : {0.0f, 0.5f, 1.0f, nan}) {
      CHECK(moments::empty().visibility().amount_before(relative) == 0.0f);
      CHECK(moments::of(relative, 0u).sum == moments::empty().sum);
    }
    CHECK(moments::of(nan, 5u).sum == moments::of(0.0f, 5u).sum);
    CHECK(moments::of(7.0f, 5u).sum == moments::of(1.0f, 5u).sum);
    const std::uint32_t opaque = optical_depth(1.0f);
    const std::uint32_t thin = optical_depth(0.01f);
    const auto hidden = moments_of<N>({{0.0f, opaque}, {1.0f, thin}}).visibility();
    CHECK(transmittance_of(hidden.amount_before_fragment(1.0f, thin)) < 1e-9f);
    CHECK(hidden.amount_before(nan) == 0.0f);
    CHECK(hidden.amount_before(9.0f) == hidden.amount_before(1.0f));
    // Sums that end.
    moments full = moments::empty();
    cells_of<atomic_cells<std::uint32_t>> cells(moments::cells, 0u);
    for (std::uint32_t i = 0u; i < 300u; ++i) {
      const moments one = moments::of(static_cast<float>(i) / 299.0f, opaque);
      full.merge(one);
      atomic_trigonometric_moments::add(cells, 0u, one);
    }
    CHECK(full.sum[0] == 0xffffffffu);
    CHECK(atomic_trigonometric_moments::load<moments>(cells, 0u).sum == full.sum);
  });
}

}  // namespace pelage::test
