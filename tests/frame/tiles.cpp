// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order/tiles.hpp"

#include "frame/fibres.hpp"
#include "frame/model/built_in.hpp"
#include "frame/raster/occluder.hpp"
#include "frame/raster/sweep.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <span>
#include <vector>

namespace pelage::test {

using namespace frame;

std::vector<std::vector<std::uint32_t>> lists_of(const tiles& cut) {
  std::vector<std::vector<std::uint32_t>> lists;
  for (int t = 0; t < cut.count(); ++t) {
    lists.emplace_back(cut.segments(t).begin(), cut.segments(t).end());
  }
  return lists;
}

bool leaves_fragments(const raster& from, std::span<const float> limit, std::uint32_t segment, const pixel_rect& rect) {
  bool any = false;
  from.for_each(segment, rect, [&](int x, int y, const pixel_fragment& f) {
    any = any || limit.empty() || !(f.depth >= limit[static_cast<std::size_t>(y * from.from().width + x)]);
  });
  return any;
}

TEST_CASE("the tiles share out the picture's pixels, one to each") {
  const strands none = fibres_of({}, 0.0F, 1.0F);
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(32, 32), std::pair(33, 31), std::pair(100, 65)}) {
    const view v = perspective_view({0.0F, 0.0F, 1.0F}, glm::vec3(0.0F), 1.0F, width, height, 0.1F);
    const raster from(none, v, true);
    const tiles cut(from, {}, {});
    std::vector<int> owners(static_cast<std::size_t>(width * height), 0);
    for (int t = 0; t < cut.count(); ++t) {
      CHECK(cut.segments(t).empty());
      const pixel_rect r = cut.rect(t);
      for (int y = r.y0; y < r.y1; ++y) {
        for (int x = r.x0; x < r.x1; ++x)
          ++owners[static_cast<std::size_t>(y * width + x)];
      }
    }
    CHECK(std::count(owners.begin(), owners.end(), 1) == width * height);
  }
}

TEST_CASE("a tile lists every segment that leaves visible fragments in it, once, and none that is hidden whole") {
  holds("nothing is missing", [] {
    const strands fibres = fibres_of(any_lines(8, glm::vec3(0.0F), 1.0F), any_float(0.0F, 0.1F), 1.0F);
    const float distance = any_float(0.1F, 3.0F);
    const view v = perspective_view({0.0F, 0.0F, distance}, glm::vec3(0.0F), 0.5F, 70, 50, 0.05F);
    const raster from(fibres, v, true);
    const std::vector<float> wall(70 * 50, any_float(0.05F, 4.0F));
    const std::span<const float> limit = *rc::gen::arbitrary<bool>() ? std::span(wall) : std::span<const float>();
    const tiles cut(from, limit, {});
    const occluder hidden(from, limit);
    for (int t = 0; t < cut.count(); ++t) {
      const std::set<std::uint32_t> listed(cut.segments(t).begin(), cut.segments(t).end());
      RC_ASSERT(listed.size() == cut.segments(t).size());
      for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
        if (leaves_fragments(from, limit, s, cut.rect(t))) RC_ASSERT(listed.contains(s));
        if (hidden.hides(s, from.bounds(s))) RC_ASSERT(!listed.contains(s));
      }
    }
  });
}

TEST_CASE("a tile's list follows the drawing order, on any number of threads") {
  const strands fibres = prepare_strands(make_built_in(900, 24, 1), {});  // more than two tasks bin
  const view v = perspective_view({0.0F, 0.0F, 6.0F}, glm::vec3(0.0F), 0.4F, 100, 70, 0.1F);
  const raster from(fibres, v, true);
  std::vector<std::uint32_t> backwards(fibres.segment_count());
  std::iota(backwards.rbegin(), backwards.rend(), 0U);

  const auto lists_on = [&](int count, std::span<const std::uint32_t> order) {
    return on_threads(count, [&] { return lists_of(tiles(from, {}, order)); });
  };
  const auto by_number = lists_on(1, {});
  for (const int count : {1, 2, 4}) {
    CHECK(lists_on(count, {}) == by_number);
    auto reversed = lists_on(count, backwards);
    for (std::vector<std::uint32_t>& list : reversed) {
      CHECK(std::is_sorted(list.rbegin(), list.rend()));
      std::reverse(list.begin(), list.end());
    }
    CHECK(reversed == by_number);
  }
}

}  // namespace pelage::test
