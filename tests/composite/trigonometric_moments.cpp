// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/trigonometric_moments.hpp>

#include "composite/moment_oracle.hpp"
#include "property.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace pelage::test {

static_assert(sizeof(trigonometric_moments<2>) == 20 && sizeof(trigonometric_moments<3>) == 28);

template <class Check>
void for_both_orders(const Check& check) {
  check.template operator()<2>();
  check.template operator()<3>();
}

TEST_CASE("each sum is rounded by a unit a fragment and by the last digits of a float") {
  for_both_orders([]<std::uint32_t N>() {
    holds("of N = " + std::to_string(N), [] {
      const std::vector<absorber> all = draw_absorbers(1u, 60u);
      const auto moments = moments_of<trigonometric_moments<N>>(all);
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
      const auto told = moments_of<trigonometric_moments<N>>(all).visibility();
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
      RC_ASSERT(moments_of<trigonometric_moments<N>>(all).visibility().amount_before_fragment(0.0f, all[0].amount) ==
                0.0f);
      all.push_back({1.0f, amount()});
      if (N == 3u && *rc::gen::arbitrary<bool>()) all.push_back({0.2f + 0.6f * draw_share(), amount()});
      const auto told = moments_of<trigonometric_moments<N>>(all).visibility();
      for (const absorber& each : all) {
        const float before = told.amount_before_fragment(each.relative, each.amount);
        RC_ASSERT(std::abs(passed(before) - passed(amount_before(all, each.relative))) <
                  (all.size() > 2u ? 1e-2 : 1e-4));
      }
    });
  });
}

}  // namespace pelage::test
