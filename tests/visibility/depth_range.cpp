// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/visibility/depth_range.hpp>

#include "property.hpp"
#include "visibility/cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float largest = std::numeric_limits<float>::max();
constexpr float smallest = std::numeric_limits<float>::denorm_min();

static_assert(sizeof(depth_range) == 8);

/// Any float, often one that is special.
float draw_depth() {
  return *rc::gen::oneOf(
      rc::gen::map(rc::gen::arbitrary<std::uint32_t>(), [](std::uint32_t bits) { return std::bit_cast<float>(bits); }),
      rc::gen::map(rc::gen::inRange(-8, 9), [](int i) { return 0.25f * static_cast<float>(i); }),
      rc::gen::element(0.0f, -0.0f, inf, -inf, nan, largest, -largest, smallest, -smallest));
}

std::vector<float> draw_depths() {
  std::vector<float> depths(*rc::gen::inRange<std::size_t>(0u, 12u));
  for (float& depth : depths) {
    depth = draw_depth();
  }
  return depths;
}

depth_range range_of(const std::vector<float>& depths) {
  depth_range range = depth_range::empty();
  for (const float depth : depths) {
    range.extend(depth);
  }
  return range;
}

TEST_CASE("a range is that of its finite depths") {
  holds("any depths", [] {
    const std::vector<float> depths = draw_depths();
    std::vector<float> finite;
    std::copy_if(depths.begin(), depths.end(), std::back_inserter(finite), [](float d) { return std::isfinite(d); });
    const depth_range range = range_of(depths);
    RC_ASSERT(range.is_empty() == finite.empty());
    RC_ASSERT(range.nearest_depth() == (finite.empty() ? 0.0f : *std::min_element(finite.begin(), finite.end())));
    RC_ASSERT(range.farthest_depth() == (finite.empty() ? 0.0f : *std::max_element(finite.begin(), finite.end())));
  });
}

TEST_CASE("the relative depth is 0 up to the nearest, 1 from the farthest on, and never falls between") {
  holds("any depths", [] {
    const depth_range range = range_of(draw_depths());
    const float a = draw_depth();
    const float b = draw_depth();
    const float relative_a = range.relative(a);
    const float relative_b = range.relative(b);
    RC_ASSERT(relative_a >= 0.0f);
    RC_ASSERT(relative_a <= 1.0f);
    RC_ASSERT(!(a <= b) || relative_a <= relative_b);
    if (range.is_empty() || !(a > range.nearest_depth())) RC_ASSERT(relative_a == 0.0f);
    if (!range.is_empty() && a > range.nearest_depth() && a >= range.farthest_depth()) RC_ASSERT(relative_a == 1.0f);
  });
}

/// Of either sign, spread evenly over all exponents, denormals included.
float draw_any_size() {
  const auto mantissa = static_cast<float>(*rc::gen::inRange(-(1 << 24), (1 << 24) + 1));
  return std::ldexp(mantissa, *rc::gen::inRange(-149, 105));
}

TEST_CASE("the relative depth is linear within 5e-7 of itself from 2^-123 behind the nearest on") {
  holds("two ends and a share", [] {
    const float from = *rc::gen::arbitrary<bool>() ? draw_any_size() : 0.0f;
    const float to = *rc::gen::arbitrary<bool>() ? draw_any_size() : from + std::abs(draw_any_size());
    const double share = std::exp2(-0.1 * *rc::gen::inRange(0, 400));
    const float depth = static_cast<float>(double{from} + share * (double{to} - double{from}));
    RC_PRE(from < depth && depth < to && std::isfinite(to));
    const double exact = (double{depth} - double{from}) / (double{to} - double{from});
    const float found = range_of({from, to}).relative(depth);
    RC_LOG() << from << " " << depth << " " << to << " " << found << " " << exact;
    if (double{depth} - double{from} >= 0x1p-123) {
      RC_ASSERT(std::abs(found - exact) <= 5e-7 * exact);
    } else {
      RC_ASSERT(found >= 0.0f && found <= 1.0f);
    }
  });
  CHECK(range_of({0.0f, 0x1p-147f}).relative(0x1p-148f) == 0.0f);
}

TEST_CASE("a range from one end of float to the other has a middle") {
  CHECK(range_of({-largest, largest}).relative(0.0f) == 0.5f);
}

TEST_CASE("a range of one point has everything before or behind it") {
  const depth_range range = range_of({2.0f, inf, nan});
  CHECK(range.relative(1.9999999f) == 0.0f);
  CHECK(range.relative(2.0f) == 0.0f);
  CHECK(range.relative(2.0000002f) == 1.0f);
  CHECK(range.relative(inf) == 1.0f);
  CHECK(range.relative(nan) == 0.0f);
}

TEST_CASE("threads and merges in any order leave the same bits") {
  holds("1 to 8 threads", [] {
    const std::vector<float> depths = draw_depths();
    const depth_range expected = range_of(depths);
    for (std::uint32_t threads = 1u; threads <= 8u; threads *= 2u) {
      cells_of<shaken_cells> storage(6u, 0u);
      deal_to_threads(threads, depths.size(),
                      [&](std::size_t i) { atomic_depth_range::extend(storage, 1u, depths[i]); });
      const depth_range built = atomic_depth_range::load(storage, 1u);
      RC_ASSERT(built.nearest == expected.nearest);
      RC_ASSERT(built.farthest == expected.farthest);
      RC_ASSERT(atomic_depth_range::load(storage, 0u).is_empty());
      RC_ASSERT(atomic_depth_range::load(storage, 2u).is_empty());
    }
    const auto middle = depths.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(depths) + 1);
    depth_range merged = range_of({middle, depths.end()});
    merged.merge(range_of({depths.begin(), middle}));
    RC_ASSERT(merged.nearest == expected.nearest);
    RC_ASSERT(merged.farthest == expected.farthest);
  });
}

}  // namespace pelage::test
