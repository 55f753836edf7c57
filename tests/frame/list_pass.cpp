// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order/list_pass.hpp"

#include "frame/fibres.hpp"
#include "frame/raster/sweep.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelage::test {

using namespace frame;

TEST_CASE("every pixel gets its visible fragments once, in the order of drawing, on any number of threads") {
  holds("brute force", [] {
    const strands fibres = fibres_of(any_lines(8, glm::vec3(0.0F), 1.0F), any_float(0.0F, 0.1F), 1.0F);
    const view v = any_perspective(3.0F, 0.1F);
    const raster from(fibres, v, *rc::gen::arbitrary<bool>());
    const auto width = static_cast<std::size_t>(v.width);
    std::vector<float> limit(width * static_cast<std::size_t>(v.height), std::numeric_limits<float>::infinity());
    if (*rc::gen::arbitrary<bool>()) std::fill(limit.begin(), limit.end(), 3.0F);
    const std::vector<std::uint32_t> order = shuffled(fibres.segment_count(), *rc::gen::arbitrary<std::uint32_t>());

    std::vector<std::vector<std::uint32_t>> truth(limit.size());
    std::uint64_t count = 0;
    std::size_t longest = 0;
    for (const std::uint32_t segment : order) {
      from.for_each(segment, whole(v), [&](int x, int y, const pixel_fragment& f) {
        if (f.depth >= limit[0]) return;
        std::vector<std::uint32_t>& list = truth[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
        list.push_back(segment);
        longest = std::max(longest, list.size());
        ++count;
      });
    }
    std::vector<std::vector<std::uint32_t>> seen(limit.size());
    std::vector<int> visits(limit.size(), 0);
    const order_report report = on_threads(*rc::gen::element(1, 2, 4), [&] {
      return run_list_pass(from, limit, order, [&](int x, int y, std::span<pixel_fragment> all) {
        const std::size_t p = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
        ++visits[p];
        for (const pixel_fragment& f : all) {
          const pixel_fragment same = from.at(f.id, x, y);
          const bool kept = f.depth == same.depth && f.coverage == same.coverage && f.along == same.along;
          seen[p].push_back(kept ? f.id : 0xffffffffU);
        }
      });
    });
    RC_ASSERT(seen == truth);
    RC_ASSERT(std::count(visits.begin(), visits.end(), 1) == static_cast<std::ptrdiff_t>(visits.size()));
    RC_ASSERT((report.fragments == count && report.longest == longest && report.refused == 0));
  });
}

}  // namespace pelage::test
