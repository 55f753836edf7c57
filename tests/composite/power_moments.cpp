// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/optical_depth.hpp>
#include <pelage/composite/power_moments.hpp>

#include "composite/layers.hpp"
#include "composite/moment_oracle.hpp"
#include "property.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage::test {

static_assert(sizeof(power_moments<4>) == 20 && sizeof(power_moments<6>) == 28 && sizeof(power_visibility) == 32);

template <class Check>
void for_both_orders(const Check& check) {
  check.template operator()<4>();
  check.template operator()<6>();
}

TEST_CASE("each sum is rounded by a unit a fragment and by the last digits of a float") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      const std::vector<absorber> all = draw_absorbers(1u, 60u);
      const auto moments = moments_of<power_moments<N>>(all);
      for (std::uint32_t k = 0u; k <= N; ++k) {
        long double exact = 0.0L;
        long double amounts = 0.0L;
        for (const absorber& each : all) {
          exact += each.amount * (1.0L + std::cos(k * std::acos(position_of(each)))) / 2.0L;
          amounts += each.amount;
        }
        const auto count = static_cast<long double>(all.size());
        RC_ASSERT(std::abs(exact - moments.sum[k]) <= count + 1e-6L * amounts);
      }
    });
  });
}

TEST_CASE("what lies before a fragment is within the bounds, and these never fall with depth") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      const std::vector<absorber> all = draw_absorbers(1u, 40u);
      const power_visibility told = moments_of<power_moments<N>>(all).visibility();
      moment_bounds last{0.0f, 0.0f};
      for (std::uint32_t i = 0u; i <= 64u; ++i) {
        const float relative = static_cast<float>(i) / 64.0f;
        const moment_bounds bounds = told.bounds_before(relative);
        RC_ASSERT(passed(bounds.least) - passed(amount_before(all, relative)) > -1e-4);
        RC_ASSERT(passed(bounds.most) - passed(amount_before(all, relative)) < 1e-4);
        RC_ASSERT(passed(bounds.least) - passed(last.least) < 1e-4);
        RC_ASSERT(passed(bounds.most) - passed(last.most) < 1e-4);
        RC_ASSERT((bounds.least >= 0.0f && bounds.least <= bounds.most));
        last = bounds;
      }
      for (const absorber& each : all) {
        const double before = passed(amount_before(all, each.relative));
        const moment_bounds bounds = told.bounds_before(each.relative);
        RC_ASSERT(passed(bounds.least) - before > -1e-4);
        RC_ASSERT(passed(bounds.most) - before < 1e-4);
      }
    });
  });
}

TEST_CASE("each bound is had by some distribution that has the same moments") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      // So many, and so far apart, that the moments tell them from fewer.
      std::vector<absorber> all;
      for (std::uint32_t i = 0u; i < 8u; ++i) {
        all.push_back({i == 0u   ? 0.0f
                       : i == 7u ? 1.0f
                                 : (static_cast<float>(i) + 0.5f * draw_share()) / 7.5f,
                       optical_depth(0.1f + 0.8f * draw_share())});
      }
      const float relative = 0.01f + 0.98f * draw_share();
      const std::vector<node> nodes = representing_measure<N>(all, relative);
      long double nearer = 0.0L;
      long double amount = 0.0L;
      for (std::uint32_t k = 0u; k <= N; ++k) {
        long double of_nodes = 0.0L;
        long double of_all = 0.0L;
        for (const node& each : nodes)
          of_nodes += each.weight * std::pow(each.position, k);
        for (const absorber& each : all)
          of_all += each.amount * std::pow(position_of(each), k);
        RC_PRE(std::abs(nodes.back().position) < 50.0L && std::abs(nodes.front().position) < 50.0L);
        RC_ASSERT(std::abs(of_nodes - of_all) < 1e-4L * std::abs(of_all) + 1e-4L * all.front().amount);
        if (k == 0u) amount = of_all;
      }
      const long double here = nodes_at(nodes, relative);
      for (const node& each : nodes) {
        if (each.position < 2.0L * relative - 1.0L - 1e-9L) nearer += each.weight;
      }
      const moment_bounds bounds = moments_of<power_moments<N>>(all).visibility().bounds_before(relative);
      RC_ASSERT(std::abs(bounds.least - nearer) < 2e-3L * amount);
      RC_ASSERT(std::abs(bounds.most - nearer - here) < 2e-3L * amount);
    });
  });
}

TEST_CASE("a fragment alone, all at one depth, and the nearest have nothing before them, exactly") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      const std::vector<absorber> all = draw_absorbers(1u, 20u);
      auto together = power_moments<N>::empty();
      for (const absorber& each : all)
        together.add(0.0f, each.amount);
      for (const absorber& each : all)
        RC_ASSERT(together.visibility().amount_before_fragment(0.0f, each.amount) == 0.0f);
      RC_ASSERT(moments_of<power_moments<N>>(all).visibility().amount_before_fragment(0.0f, all.front().amount) ==
                0.0f);
      const power_visibility one = power_moments<N>::of(0.0f, all.front().amount).visibility();
      RC_ASSERT(one.amount_before(0.0f) == 0.0f);
      RC_ASSERT(one.amount == all.front().amount);
    });
  });
}

TEST_CASE("two fragments are told apart, and so are as many as half of N that are not near to each other") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      std::vector<absorber> all{{0.0f, optical_depth(0.999f * draw_share())},
                                {1.0f, optical_depth(0.999f * draw_share())}};
      const power_visibility two = moments_of<power_moments<N>>(all).visibility();
      RC_ASSERT(std::abs(passed(two.amount_before_fragment(1.0f, all[1].amount)) - passed(all[0].amount)) < 1e-4);
      if (N == 6u) {
        for (absorber& each : all)
          each.amount = optical_depth(0.05f + 0.9f * draw_share());
        all.push_back({0.2f + 0.6f * draw_share(), optical_depth(0.05f + 0.9f * draw_share())});
        const power_visibility three = moments_of<power_moments<N>>(all).visibility();
        for (const absorber& each : all) {
          const float before = three.amount_before_fragment(each.relative, each.amount);
          RC_ASSERT(std::abs(passed(before) - passed(amount_before(all, each.relative))) < 3e-3);
        }
      }
    });
  });
}

TEST_CASE("each of two is within 2^-17 of the octaves and 8 units, each of three a twentieth apart within 1e-3") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      const auto draw_alpha = [] { return *rc::gen::arbitrary<bool>() ? 1.0f : 0.01f + 0.99f * draw_share(); };
      std::vector<absorber> all{{0.0f, optical_depth(draw_alpha())}, {1.0f, optical_depth(draw_alpha())}};
      const power_visibility two = moments_of<power_moments<N>>(all).visibility();
      const double octaves = double{static_cast<float>(two.amount)};
      const double error = two.amount_before_fragment(1.0f, all[1].amount) - double{static_cast<float>(all[0].amount)};
      RC_ASSERT(std::abs(error) <= octaves / 131072.0 + 8.0);
      if (N == 6u) {
        all.push_back({0.05f + 0.9f * draw_share(), optical_depth(draw_alpha())});
        const power_visibility three = moments_of<power_moments<N>>(all).visibility();
        for (const absorber& each : all) {
          const float before = three.amount_before_fragment(each.relative, each.amount);
          RC_ASSERT(std::abs(passed(before) - passed(amount_before(all, each.relative))) < 1e-3);
        }
      }
    });
  });
}

TEST_CASE("with N = 6 what lies before is within bounds that do not fall, by 1e-2 in what passes") {
  // All but one at the far end, too near to each other for float moments: found by search.
  const std::uint32_t dense = 10449902u;
  const std::vector<absorber> all{
      {0.0f, 58037u}, {0.999733f, dense}, {0.999774f, 4305703u}, {0.999838f, dense}, {1.0f, dense}};
  const power_visibility told = moments_of<power_moments<6>>(all).visibility();
  double least = 1.0;
  for (const absorber& each : all) {
    const moment_bounds bounds = told.bounds_before(each.relative);
    CHECK(passed(bounds.least) < least + 1e-2);
    least = std::min(least, passed(bounds.least));
    CHECK(passed(bounds.least) > passed(amount_before(all, each.relative)) - 1e-2);
    CHECK(passed(bounds.most) < passed(amount_before(all, each.relative)) + 1e-2);
  }
}

TEST_CASE("sums that passed their ends have bounds, too") {
  for_both_orders([]<std::uint32_t N>() {
    auto full = power_moments<N>::empty();
    for (std::uint32_t i = 0u; i < 300u; ++i)
      full.add(static_cast<float>(i) / 299.0f, optical_depth(1.0f));
    const moment_bounds bounds = full.visibility().bounds_before(0.5f);
    CHECK((bounds.least >= 0.0f && bounds.most <= 4294967296.0f && bounds.least <= bounds.most));
  });
}

TEST_CASE("roots of cubics with three real ones, and of quadratics, are found") {
  holds("near and far", [] {
    const auto draw = [] { return static_cast<double>(*rc::gen::inRange(-1000, 1001)) / 100.0; };
    std::array<double, 3> truth{draw(), draw(), *rc::gen::arbitrary<bool>() ? draw() : 0.0};
    const double c2 = -(truth[0] + truth[1] + truth[2]);
    const double c1 = truth[0] * truth[1] + truth[1] * truth[2] + truth[2] * truth[0];
    const double c0 = -truth[0] * truth[1] * truth[2];
    const auto found = real_roots(static_cast<float>(c2), static_cast<float>(c1), static_cast<float>(c0));
    // Each found one makes the polynomial vanish, as far as floats tell.
    for (const float root : found) {
      const double y = root;
      const double size = std::abs(y * y * y) + std::abs(c2 * y * y) + std::abs(c1 * y) + std::abs(c0);
      RC_ASSERT(std::abs(((y + c2) * y + c1) * y + c0) <= 1e-5 * size + 1e-7);
    }
    std::sort(truth.begin(), truth.end());
    const double apart = std::min(truth[1] - truth[0], truth[2] - truth[1]);
    if (apart > 1.0) {
      std::array<float, 3> sorted = found;
      std::sort(sorted.begin(), sorted.end());
      for (std::size_t i = 0; i < 3u; ++i)
        RC_ASSERT(std::abs(double{sorted[i]} - truth[i]) < 1e-3);
    }
  });
}

}  // namespace pelage::test
