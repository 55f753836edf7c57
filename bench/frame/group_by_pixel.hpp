// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "frame/order_pass.hpp"

namespace pelage::frame {

/// Groups a tile's fragments by pixel, each pixel's in order of arrival: a counting sort. `pixel_of` has an entry, less
/// than `end.size()`, for each of `arrived`; afterwards pixel p's group ends at end[p], where that of p + 1 begins.
template <class Pixel, class End>
void group_by_pixel(std::span<const Pixel> pixel_of, std::span<const seen_fragment> arrived,
                    std::span<seen_fragment> grouped, std::span<End> end) {
  std::fill(end.begin(), end.end(), End{0});
  for (const Pixel p : pixel_of)
    ++end[p];
  End begin = 0;
  for (End& one : end)
    begin += std::exchange(one, begin);
  for (std::size_t i = 0; i < arrived.size(); ++i)
    grouped[end[pixel_of[i]]++] = arrived[i];
}

}  // namespace pelage::frame
