// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Depth peeling, single and dual, against sorting: any depths, any order.
#include <pelage/composite/depth_peeling.hpp>

#include "../input.hpp"

#include <cstddef>
#include <vector>

namespace {

using namespace pelage;
using fuzz::law;

/// A pass over all fragments, in another order each time.
template <class Peeling>
void offer_all(Peeling& peeling, const std::vector<fragment>& all, std::size_t pass) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    peeling.offer(all[(i + 7 * pass) % all.size()]);
  }
}

std::vector<fragment> peel(const std::vector<fragment>& all) {
  std::vector<fragment> layers;
  depth_peeling peeling = depth_peeling::begin();
  for (std::size_t pass = 0; pass <= all.size(); ++pass) {
    offer_all(peeling, all, pass);
    if (!is_fragment(peeling.layer())) {
      break;
    }
    layers.push_back(peeling.layer());
    peeling.advance();
  }
  return layers;
}

std::vector<fragment> peel_both(const std::vector<fragment>& all) {
  std::vector<fragment> fronts;
  std::vector<fragment> backs;
  dual_depth_peeling peeling = dual_depth_peeling::begin();
  for (std::size_t pass = 0; pass <= all.size() / 2 + 1; ++pass) {
    offer_all(peeling, all, pass);
    if (!is_fragment(peeling.front())) {
      break;
    }
    fronts.push_back(peeling.front());
    if (is_fragment(peeling.back())) {
      backs.push_back(peeling.back());
    }
    peeling.advance();
  }
  fronts.insert(fronts.end(), backs.rbegin(), backs.rend());
  return fronts;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const std::vector<fragment> all = fuzz::take_fragments(in, 48);
  const std::vector<fragment> in_order = fuzz::sorted(all);
  law(fuzz::equal(peel(all), in_order), "peeled layers are the sorted fragments, each once");
  law(fuzz::equal(peel_both(all), in_order), "dual peeling gives the same from both ends");
  return 0;
}
