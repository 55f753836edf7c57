// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What moments of powers and of angles have in common.
#include <pelage/composite/optical_depth.hpp>
#include <pelage/composite/power_moments.hpp>
#include <pelage/composite/trigonometric_moments.hpp>

#include "composite/moment_oracle.hpp"
#include "property.hpp"
#include "visibility/cells.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace pelage::test {

/// What many threads add, of either kind.
struct powers {
  template <class Cells, class Moments>
  static void add(Cells& cells, std::uint32_t first, const Moments& one) {
    atomic_power_moments::add(cells, first, one);
  }
  template <class Moments, class Cells>
  static Moments load(Cells& cells, std::uint32_t first) {
    return atomic_power_moments::load<Moments>(cells, first);
  }
};
struct angles {
  template <class Cells, class Moments>
  static void add(Cells& cells, std::uint32_t first, const Moments& one) {
    atomic_trigonometric_moments::add(cells, first, one);
  }
  template <class Moments, class Cells>
  static Moments load(Cells& cells, std::uint32_t first) {
    return atomic_trigonometric_moments::load<Moments>(cells, first);
  }
};

template <class Check>
void for_all_moments(const Check& check) {
  check.template operator()<power_moments<4>, powers>("4 powers");
  check.template operator()<power_moments<6>, powers>("6 powers");
  check.template operator()<trigonometric_moments<2>, angles>("2 angles");
  check.template operator()<trigonometric_moments<3>, angles>("3 angles");
}

TEST_CASE("any order of fragments, any split into parts and any number of threads give the same bits") {
  for_all_moments([]<class Moments, class Atomic>(const std::string& name) {
    holds("of " + name, [] {
      const std::vector<absorber> all = draw_absorbers(0u, 60u);
      std::vector<absorber> shuffled = all;
      std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
      const auto cut = static_cast<std::ptrdiff_t>(*rc::gen::inRange<std::size_t>(0u, all.size() + 1u));
      auto parts = moments_of<Moments>({shuffled.begin(), shuffled.begin() + cut});
      parts.merge(moments_of<Moments>({shuffled.begin() + cut, shuffled.end()}));
      RC_ASSERT(parts.sum == moments_of<Moments>(all).sum);
      for (std::uint32_t threads = 1u; threads <= 4u; threads *= 2u) {
        cells_of<shaken_cells> cells(3u * Moments::cells, 0u);
        deal_to_threads(threads, all.size(), [&](std::size_t i) {
          Atomic::add(cells, 1u, Moments::of(shuffled[i].relative, shuffled[i].amount));
        });
        RC_ASSERT(Atomic::template load<Moments>(cells, 1u).sum == parts.sum);
        RC_ASSERT(Atomic::template load<Moments>(cells, 0u).sum == Moments::empty().sum);
        RC_ASSERT(Atomic::template load<Moments>(cells, 2u).sum == Moments::empty().sum);
      }
    });
  });
}

TEST_CASE("nothing, NaN and opaque fragments have a defined place") {
  for_all_moments([]<class Moments, class Atomic>(const std::string& name) {
    CAPTURE(name);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float relative : {0.0f, 0.5f, 1.0f, nan}) {
      CHECK(Moments::empty().visibility().amount_before(relative) == 0.0f);
      CHECK(Moments::of(relative, 0u).sum == Moments::empty().sum);
    }
    CHECK(Moments::of(nan, 5u).sum == Moments::of(0.0f, 5u).sum);
    CHECK(Moments::of(-3.0f, 5u).sum == Moments::of(0.0f, 5u).sum);
    CHECK(Moments::of(7.0f, 5u).sum == Moments::of(1.0f, 5u).sum);
    const std::uint32_t opaque = optical_depth(1.0f);
    const std::uint32_t thin = optical_depth(0.01f);
    const auto hidden = moments_of<Moments>({{0.0f, opaque}, {1.0f, thin}}).visibility();
    CHECK(transmittance_of(hidden.amount_before_fragment(1.0f, thin)) < 1e-9f);
    CHECK(hidden.amount_before(nan) == 0.0f);
    CHECK(hidden.amount_before(9.0f) == hidden.amount_before(1.0f));
    // Sums that end.
    auto full = Moments::empty();
    cells_of<atomic_cells<std::uint32_t>> cells(Moments::cells, 0u);
    for (std::uint32_t i = 0u; i < 300u; ++i) {
      const auto one = Moments::of(static_cast<float>(i) / 299.0f, opaque);
      full.merge(one);
      Atomic::add(cells, 0u, one);
    }
    CHECK(full.sum[0] == 0xffffffffu);
    CHECK(Atomic::template load<Moments>(cells, 0u).sum == full.sum);
  });
}

}  // namespace pelage::test
