// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/strand_share.hpp>

#include "property.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST_CASE("of 2^k strands from a multiple of 2^k on, k up to 6, one has its rank in each 2^k-th of the ranks") {
  holds("strata", [] {
    const auto bits = *rc::gen::inRange<std::uint32_t>(0, 7);
    const std::uint32_t count = 1u << bits;
    const std::uint32_t first = *rc::gen::arbitrary<std::uint32_t>() & ~(count - 1u);
    std::vector<int> in_part(count, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
      const float rank = strand_rank(first + i);
      RC_ASSERT(rank >= 0.0f);
      RC_ASSERT(rank < 1.0f);
      ++in_part[static_cast<std::size_t>(rank * static_cast<float>(count))];
    }
    RC_ASSERT(std::all_of(in_part.begin(), in_part.end(), [](int n) { return n == 1; }));
  });
}

TEST_CASE("strands whose numbers are a multiple of 64 apart have ranks without a pattern") {
  // Roots in rows of 64 would thin out by columns if ranks were the numbers' bits in reverse.
  for (const std::uint32_t stride : {64u, 128u, 320u, 1024u}) {
    int low = 0;
    for (std::uint32_t i = 0; i < 512; ++i)
      low += strand_rank(stride * i) < 0.25f ? 1 : 0;
    CHECK(low > 96);
    CHECK(low < 160);
  }
}

TEST_CASE("the mean width over all ranks is 1, whatever share is drawn") {
  holds("quadrature", [] {
    const double share = *rc::gen::oneOf(rc::gen::map(rc::gen::inRange(1, 1'000'001), [](int n) { return n / 1e6; }),
                                         rc::gen::element(1.0, 1e-9, 0.5, 0.25, 0.999999, 0.2, 1.0 / 3.0));
    // The step is cubic on either side of its middle, where Simpson's rule is exact; outside of it all is constant.
    const double half_band = 0.25 * std::min(share, 1.0 - share);
    const double lower = share - half_band;
    const double upper = share + half_band;
    const auto at = [&](double rank) { return width_factor(std::clamp(rank, 0.0, 1.0 - 1e-16), share); };
    double sum = lower * at(0.5 * lower);
    const int pieces = 16;
    for (int i = 0; i < pieces && half_band > 0.0; ++i) {
      const double a = lower + (upper - lower) * i / pieces;
      const double b = lower + (upper - lower) * (i + 1) / pieces;
      sum += (b - a) / 6.0 * (at(a) + 4.0 * at(0.5 * (a + b)) + at(b));
    }
    RC_ASSERT(std::abs(sum - 1.0) < 1e-9);
    RC_ASSERT(upper >= 1.0 || at(0.5 * (upper + 1.0)) == 0.0);
  });
}

TEST_CASE("the widths of many strands by their numbers sum to what they were") {
  for (const float share : {0.7f, 0.25f, 0.1f, 0.02f}) {
    double sum = 0.0;
    const std::uint32_t count = 1u << 16u;
    for (std::uint32_t strand = 0; strand < count; ++strand)
      sum += width_factor(strand_rank(strand), share);
    CHECK(sum / count == doctest::Approx(1.0).epsilon(1e-3));
  }
}

TEST_CASE("a strand that is drawn at a share is drawn at each greater one") {
  holds("monotone", [](std::uint32_t strand) {
    const float rank = strand_rank(strand);
    const float share = static_cast<float>(*rc::gen::inRange(1, 10'001)) / 1e4f;
    const float more = share + (1.0f - share) * static_cast<float>(*rc::gen::inRange(0, 10'001)) / 1e4f;
    RC_ASSERT(width_factor(rank, share) == 0.0f || width_factor(rank, more) > 0.0f);
  });
}

TEST_CASE("a width never jumps when the share changes a little, and is at most what the share asks") {
  holds("continuous", [] {
    const double rank = *rc::gen::inRange(0, 1'000'000) / 1e6;
    const double share = *rc::gen::inRange(1, 1'000'001) / 1e6;
    const double step = 1e-7 * std::min(share, std::max(1.0 - share, 1e-6));
    const double now = width_factor(rank, share);
    const double then = width_factor(rank, std::min(share + step, 1.0));
    // The slope of the step is at most 3/4 of the factor over half the band.
    RC_ASSERT(std::abs(then - now) * share < 1e-5);
    RC_ASSERT(now >= 0.0);
    RC_ASSERT(now * share <= 1.0 + 1e-12);
  });
}

TEST_CASE("where all strands stay, each is as wide as it is") {
  for (std::uint32_t strand = 0; strand < 1000; ++strand) {
    CHECK(width_factor(strand_rank(strand), 1.0f) == 1.0f);
    CHECK(width_factor(strand_rank(strand), kept_share(0.1f, 0.0f, 0.01f)) == 1.0f);
    CHECK(width_factor(strand_rank(strand), kept_share(2.0f, 1.0f, 0.01f)) == 1.0f);
  }
  for (const float outside : {0.0f, -1.0f, 1.5f, inf, nan})
    CHECK(width_factor(0.5f, outside) == 1.0f);
  CHECK(width_factor(nan, 0.5f) == 1.0f);
}

TEST_CASE("the share is the width over the error, within its ends") {
  CHECK(kept_share(0.25f, 0.5f, 0.01f) == 0.5f);
  CHECK(kept_share(0.0f, 0.5f, 0.01f) == 0.01f);
  CHECK(kept_share(0.001f, 1.0f, 0.01f) == 0.01f);
  CHECK(kept_share(0.5f, 0.5f, 0.01f) == 1.0f);
  CHECK(kept_share(inf, 0.5f, 0.01f) == 1.0f);
  CHECK(kept_share(0.5f, inf, 0.01f) == 0.01f);
  for (const float off : {0.0f, -1.0f, nan})
    CHECK(kept_share(0.25f, off, 0.01f) == 1.0f);
  CHECK(kept_share(nan, 0.5f, 0.01f) == 1.0f);
}

}  // namespace pelage::test
