// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <utility>

namespace pelage::frame {

/// Groups a tile's fragments by pixel, each pixel's in order of arrival: a counting sort. `pixel_of` has an entry, less
/// than `end.size()`, for each. `end[p]` says how many more places pixel p wants behind its own; afterwards, where its
/// own end. Calls `put(i, place)` for the i-th to arrive.
template <class Pixel, class End, class Put>
void group_by_pixel(std::span<const Pixel> pixel_of, std::span<End> end, Put&& put) {
  for (const Pixel p : pixel_of)
    ++end[p];
  End begin = 0;
  for (End& one : end)
    begin += std::exchange(one, begin);
  for (std::size_t i = 0; i < pixel_of.size(); ++i)
    put(i, end[pixel_of[i]]++);
}

}  // namespace pelage::frame
