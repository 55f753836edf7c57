// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/order/slice_pieces.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

/// Segments in the order of the depth slices that they lie in: linear time where a sort takes n log n. [Kim 2003;
/// Svoboda §1.3.3, which draws the farthest slice first] Within a slice they keep the order that they came in.
///
/// A counting sort in three steps, the outer two in parallel over chunks of segments: count() each chunk, place() all
/// counts, fill() from each chunk. The result depends neither on the number of chunks nor on threads. For slices that
/// no segment crosses, cut the segments at their planes first: slice_pieces.hpp. For the CPU. Memory: the caller's, 4
/// bytes a slice and chunk and 4 a segment.
namespace pelage::inline PELAGE_ABI::slice_sort {

/// Counts a chunk's segments by slice. `slice`: of each segment, < counts.size(). `counts`: one a slice, the chunk's
/// own.
inline void count(std::span<const std::uint32_t> slice, std::span<std::uint32_t> counts) noexcept {
  for (std::uint32_t& n : counts) {
    n = 0u;
  }
  for (const std::uint32_t s : slice) {
    PELAGE_ASSERT(s < counts.size());
    ++counts[s];
  }
}

/// Turns the counts of all chunks, chunk by chunk, into where each chunk's part of each slice begins in the order.
/// `slices`: [1, counts.size()], a divisor of it. O(counts.size()).
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

/// Writes a chunk's segments to their places, nearest slice first. `first`: number of the chunk's first segment.
/// `places`: the chunk's own, moved on as they fill. Chunks write to different elements of `order`.
inline void fill(std::span<const std::uint32_t> slice, std::uint32_t first, std::span<std::uint32_t> places,
                 std::span<std::uint32_t> order) noexcept {
  std::uint32_t segment = first;
  for (const std::uint32_t s : slice) {
    order[places[s]] = segment;
    ++places[s];
    ++segment;
  }
}

/// Whether an order that was made for one direction of depth is to be made anew for another: if the cosine of their
/// angle is less than 0.95, which is 18.2°. Until then the order of a turning camera may be kept. [Svoboda §2.5.1,
/// whose directions are from the camera to the model's middle] A model that has changed needs a new order, too.
/// `sorted`, `seen`: unit. NaN, or a direction of length 0, as of an order that was never made: true.
[[nodiscard]] inline bool is_stale(const glm::vec3& sorted, const glm::vec3& seen) noexcept {
  return !(glm::dot(sorted, seen) >= 0.95f);
}

}  // namespace pelage::slice_sort
