// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "../input.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pelage::fuzz {

/// An amount at a depth or, once placed, at a position among layers.
struct amount_at {
  float at;
  std::uint32_t amount;
};

/// Up to `most` fragments, depths of any bits: their number comes first.
inline std::vector<amount_at> take_amounts(input& in, std::uint32_t most) {
  std::vector<amount_at> all;
  for (std::uint32_t left = in.below(most + 1); left > 0 && !in.empty(); --left) {
    const auto depth = in.take<float>();
    all.push_back({depth, in.take<std::uint32_t>()});
  }
  return all;
}

/// Up to `most` depths of any bits but NaN, nearest first.
inline std::vector<float> take_depths(input& in, std::size_t most) {
  std::vector<float> all;
  while (!in.empty() && all.size() < most) {
    const auto depth = in.take<float>();
    if (depth == depth) {
      all.push_back(depth);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// For structs without padding.
template <class Value>
bool same_bits(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace pelage::fuzz
