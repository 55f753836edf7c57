// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/depth_peeling.hpp>

#include "order/oracle.hpp"
#include "property.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pelage::test {

/// The fragments that structures take, in the total order.
std::vector<fragment> sorted(std::vector<fragment> all) {
  std::erase_if(all, [](fragment f) { return !is_fragment(f); });
  std::sort(all.begin(), all.end(), before);
  return all;
}

bool equal(const std::vector<fragment>& a, const std::vector<fragment>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

TEST_CASE("peeling finds all layers in the total order, then none") {
  holds("any fragments", [] {
    const std::vector<fragment> all = *any_fragments();
    std::vector<fragment> found;
    depth_peeling peeling = depth_peeling::begin();
    for (std::size_t pass = 0; pass <= all.size() + 1u; ++pass) {
      for (const fragment f : all) {
        peeling.offer(f);
      }
      if (is_fragment(peeling.layer())) found.push_back(peeling.layer());
      peeling.advance();
    }
    RC_ASSERT(equal(found, sorted(all)));
  });
}

TEST_CASE("dual peeling finds all layers from both ends in half the passes, then none") {
  holds("any fragments", [] {
    const std::vector<fragment> all = *any_fragments();
    const std::vector<fragment> expected = sorted(all);
    std::vector<fragment> front;
    std::vector<fragment> back;
    dual_depth_peeling peeling = dual_depth_peeling::begin();
    for (std::size_t pass = 0; pass < (expected.size() + 1u) / 2u + 2u; ++pass) {
      for (const fragment f : all) {
        peeling.offer(f);
      }
      if (is_fragment(peeling.front())) front.push_back(peeling.front());
      if (is_fragment(peeling.back())) back.push_back(peeling.back());
      peeling.advance();
    }
    RC_ASSERT(front.size() == (expected.size() + 1u) / 2u);
    front.insert(front.end(), back.rbegin(), back.rend());
    RC_ASSERT(equal(front, expected));
  });
}

}  // namespace pelage::test
