// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace pelage::bench {

/// A fragment and the list, or the pixel, that it goes to.
struct offer {
  std::uint32_t list;
  fragment offered;
};

/// As many fragments for each list as `length`, all lists' in one random order, depths random with a tie now and
/// then: what a rasteriser sends whose triangles come in no order.
struct workload {
  std::uint32_t list_count;
  std::uint32_t length;
  std::vector<offer> offers;
};

inline workload make_workload(std::uint32_t list_count, std::uint32_t length) {
  std::mt19937 random(12345u);
  workload work{list_count, length, {}};
  for (std::uint32_t list = 0; list < list_count; ++list) {
    for (std::uint32_t i = 0; i < length; ++i) {
      const float depth = 1.0f + static_cast<float>(random() % 65536u) * 0x1p-12f;
      work.offers.push_back(offer{list, fragment{depth, list * length + i}});
    }
  }
  for (std::size_t i = work.offers.size(); i > 1; --i) {
    std::swap(work.offers[i - 1], work.offers[random() % i]);
  }
  return work;
}

}  // namespace pelage::bench
