// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/math.hpp>

#include <cstdint>

/// Where a segment lies among the depth slices of slice_sort, and the pieces that it falls into when it is cut at their
/// planes, so that none crosses one. [Sintorn & Assarsson 2008]
namespace pelage::inline PELAGE_ABI::slice_sort {

/// The slice that a position lies in, and for NaN the first.
[[nodiscard]] constexpr std::uint32_t slice_at(float position, std::uint32_t slices) noexcept {
  const float last = static_cast<float>(slices - 1u);
  return static_cast<std::uint32_t>(position > 0.0f ? (position < last ? position : last) : 0.0f);
}

/// The slice of a segment, [0, slices): that of its farther end [Svoboda §1.3.3]. `first`, `second`: slice_position()
/// of its ends, [0, slices]; the end of the last slice belongs to it. NaN counts as 0.
[[nodiscard]] constexpr std::uint32_t slice_of(float first, float second, std::uint32_t slices) noexcept {
  const std::uint32_t a = slice_at(first, slices);
  const std::uint32_t b = slice_at(second, slices);
  return a > b ? a : b;
}

/// What a plane-cut leaves of a segment in one slice.
struct piece {
  std::uint32_t slice;  ///< [0, slices)
  float begin;          ///< position on the segment where it begins, [0, 1]
  float end;            ///< and ends, [begin, 1]
};

/// The number of slices that a segment passes, [1, slices]. Parameters as slice_of().
[[nodiscard]] constexpr std::uint32_t piece_count(float first, float second, std::uint32_t slices) noexcept {
  const std::uint32_t a = slice_at(first, slices);
  const std::uint32_t b = slice_at(second, slices);
  return (a > b ? a - b : b - a) + 1u;
}

/// Where on a segment, [0, 1], it leaves a slice for the next one along it.
[[nodiscard]] constexpr float end_in_slice(float first, float second, std::uint32_t slice) noexcept {
  const float plane = static_cast<float>(second > first ? slice + 1u : slice);
  return saturate((plane - first) / (second - first));
}

/// A segment's piece, `number` in [0, piece_count()), counted from its first end. Where one ends the next begins, at
/// the same bits; the first begins at 0 and the last ends at 1.
[[nodiscard]] constexpr piece piece_at(float first, float second, std::uint32_t slices, std::uint32_t number) noexcept {
  const std::uint32_t from = slice_at(first, slices);
  const std::uint32_t to = slice_at(second, slices);
  PELAGE_ASSERT(number < piece_count(first, second, slices));
  const std::uint32_t slice = from < to ? from + number : from - number;
  const std::uint32_t before = from < to ? slice - 1u : slice + 1u;  // meaningless, and not used, for the first
  return piece{slice, slice == from ? 0.0f : end_in_slice(first, second, before),
               slice == to ? 1.0f : end_in_slice(first, second, slice)};
}

}  // namespace pelage::slice_sort
