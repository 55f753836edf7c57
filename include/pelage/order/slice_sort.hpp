// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/math.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

/// Segments in the order of the depth slices that they lie in: linear time where a sort takes n log n. [Kim 2003;
/// Svoboda §1.3.3] Within a slice they keep the order that they came in.
///
/// A counting sort in three steps, the outer two in parallel over chunks of segments: count() each chunk, place() all
/// counts, fill() from each chunk. The result depends neither on the number of chunks nor on threads. For slices that
/// no segment crosses, cut the segments at their planes first [Sintorn & Assarsson 2008]: piece_count(), piece_at().
/// For the CPU. Memory: the caller's, 4 bytes a slice and chunk and 4 a segment.
namespace pelage::slice_sort {

/// The slice of a segment, [0, slices): that of its farther end. `first`, `second`: slice_position() of its ends,
/// [0, slices]; the end of the last slice belongs to it. NaN counts as 0.
[[nodiscard]] constexpr std::uint32_t slice_of(float first, float second, std::uint32_t slices) noexcept;

/// What a plane-cut leaves of a segment in one slice.
struct piece {
  std::uint32_t slice;  ///< [0, slices)
  float begin;          ///< position on the segment where it begins, [0, 1]
  float end;            ///< and ends, [begin, 1]
};

/// The number of slices that a segment passes, [1, slices]. Parameters as slice_of().
[[nodiscard]] constexpr std::uint32_t piece_count(float first, float second, std::uint32_t slices) noexcept;

/// A segment's piece, `number` in [0, piece_count()), counted from its first end. Where one ends the next begins, at the
/// same bits; the first begins at 0 and the last ends at 1.
[[nodiscard]] constexpr piece piece_at(float first, float second, std::uint32_t slices, std::uint32_t number) noexcept;

/// Counts a chunk's segments by slice. `slice`: of each segment, < counts.size(). `counts`: one a slice, the chunk's
/// own.
inline void count(std::span<const std::uint32_t> slice, std::span<std::uint32_t> counts) noexcept;

/// Turns the counts of all chunks, chunk by chunk, into where each chunk's part of each slice begins in the order.
/// `slices`: [1, counts.size()], a divisor of it. O(counts.size()).
inline void place(std::span<std::uint32_t> counts, std::uint32_t slices) noexcept;

/// Writes a chunk's segments to their places, nearest slice first. `first`: number of the chunk's first segment.
/// `places`: the chunk's own, moved on as they fill. Chunks write to different elements of `order`.
inline void fill(std::span<const std::uint32_t> slice, std::uint32_t first, std::span<std::uint32_t> places,
                 std::span<std::uint32_t> order) noexcept;

// ---------------------------------------------------------------------------------------------------------

/// The slice that a position lies in, and for NaN the first.
[[nodiscard]] constexpr std::uint32_t slice_at(float position, std::uint32_t slices) noexcept {
  const float last = static_cast<float>(slices - 1u);
  return static_cast<std::uint32_t>(position > 0.0f ? (position < last ? position : last) : 0.0f);
}

constexpr std::uint32_t slice_of(float first, float second, std::uint32_t slices) noexcept {
  const std::uint32_t a = slice_at(first, slices);
  const std::uint32_t b = slice_at(second, slices);
  return a > b ? a : b;
}

constexpr std::uint32_t piece_count(float first, float second, std::uint32_t slices) noexcept {
  const std::uint32_t a = slice_at(first, slices);
  const std::uint32_t b = slice_at(second, slices);
  return (a > b ? a - b : b - a) + 1u;
}

/// Where on a segment, [0, 1], it leaves a slice for the next one along it.
[[nodiscard]] constexpr float end_in_slice(float first, float second, std::uint32_t slice) noexcept {
  const float plane = static_cast<float>(second > first ? slice + 1u : slice);
  return saturate((plane - first) / (second - first));
}

constexpr piece piece_at(float first, float second, std::uint32_t slices, std::uint32_t number) noexcept {
  const std::uint32_t from = slice_at(first, slices);
  const std::uint32_t to = slice_at(second, slices);
  PELAGE_ASSERT(number < piece_count(first, second, slices));
  const std::uint32_t slice = from < to ? from + number : from - number;
  const std::uint32_t before = from < to ? slice - 1u : slice + 1u;  // meaningless, and not used, for the first
  return piece{slice, slice == from ? 0.0f : end_in_slice(first, second, before),
               slice == to ? 1.0f : end_in_slice(first, second, slice)};
}

inline void count(std::span<const std::uint32_t> slice, std::span<std::uint32_t> counts) noexcept {
  for (std::uint32_t& n : counts) {
    n = 0u;
  }
  for (const std::uint32_t s : slice) {
    PELAGE_ASSERT(s < counts.size());
    ++counts[s];
  }
}

inline void place(std::span<std::uint32_t> counts, std::uint32_t slices) noexcept {
  std::uint32_t total = 0u;
  for (std::uint32_t s = 0u; s < slices; ++s) {
    for (std::size_t i = s; i < counts.size(); i += slices) {
      const std::uint32_t n = counts[i];
      counts[i] = total;
      total += n;
    }
  }
}

inline void fill(std::span<const std::uint32_t> slice, std::uint32_t first, std::span<std::uint32_t> places,
                 std::span<std::uint32_t> order) noexcept {
  std::uint32_t segment = first;
  for (const std::uint32_t s : slice) {
    order[places[s]] = segment;
    ++places[s];
    ++segment;
  }
}

}  // namespace pelage::slice_sort
