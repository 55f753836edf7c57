// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/math.hpp>

#include <atomic>
#include <bit>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// True for depths that a range takes in.
[[nodiscard]] constexpr bool is_finite_depth(float depth) noexcept {
  return (std::bit_cast<std::uint32_t>(depth) & 0x7fffffffu) < 0x7f800000u;
}

/// The nearest and the farthest depth of a texel's fragments: where the slices of its maps begin and end. 8 bytes.
/// [Sintorn & Assarsson 2009, §3.1, which finds them by two depth-tested passes or one that blends]
///
/// Holds keys (see depth_key), so that minimum and maximum are those of integers. Depends on the set of depths alone.
/// What an opaque object hides is not to be taken in: the caller's depth limit cuts fibres before this.
struct depth_range {
  std::uint32_t nearest;   ///< key of the least depth; all ones while empty
  std::uint32_t farthest;  ///< key of the greatest depth; 0 while empty

  /// A range that holds no depth.
  [[nodiscard]] static constexpr depth_range empty() noexcept { return depth_range{0xffffffffu, 0u}; }

  /// Takes in a depth; NaN and infinite depths change nothing. O(1).
  constexpr void extend(float depth) noexcept {
    if (is_finite_depth(depth)) {
      const std::uint32_t key = depth_key(depth);
      nearest = key < nearest ? key : nearest;
      farthest = key > farthest ? key : farthest;
    }
  }

  /// Takes in another range. Associative and commutative, empty() is the identity.
  constexpr void merge(const depth_range& other) noexcept {
    nearest = other.nearest < nearest ? other.nearest : nearest;
    farthest = other.farthest > farthest ? other.farthest : farthest;
  }

  [[nodiscard]] constexpr bool is_empty() const noexcept { return nearest > farthest; }

  /// The least depth, finite; 0 while empty.
  [[nodiscard]] constexpr float nearest_depth() const noexcept { return is_empty() ? 0.0f : depth_from_key(nearest); }

  /// The greatest depth, finite; 0 while empty.
  [[nodiscard]] constexpr float farthest_depth() const noexcept { return is_empty() ? 0.0f : depth_from_key(farthest); }

  /// Where a depth lies in the range: exactly 0 up to the nearest, exactly 1 from the farthest on, linear between
  /// within 5e-7 of itself; never falls as depth grows. Less than 2⁻¹²³ behind the nearest, where its eighth is
  /// denormal: 0, or as coarse as denormals are. A range of one point: 0 up to and at it, 1 behind. An empty range, or
  /// NaN: 0.
  [[nodiscard]] constexpr float relative(float depth) const noexcept {
    const float from = nearest_depth();
    const float to = farthest_depth();
    if (is_empty() || !(depth > from)) {
      return 0.0f;
    }
    if (depth >= to) {
      return 1.0f;
    }
    // Eighths, so that a range from one end of float to the other has a length below 2^126: a GPU divides by no more.
    return saturate((0.125f * depth - 0.125f * from) / (0.125f * to - 0.125f * from));
  }
};

/// The range of a texel that many threads extend at once: cells 2 · texel, the complement of the nearest key, and
/// 2 · texel + 1, both 0 at first.
namespace atomic_depth_range {

/// depth_range::extend(). Lock-free; memory orders: core/atomic_cells.hpp.
template <cell_storage Storage>
void extend(Storage& storage, std::uint32_t texel, float depth) noexcept {
  PELAGE_ASSERT(texel < storage.size() / 2u);
  if (is_finite_depth(depth)) {
    const std::uint32_t key = depth_key(depth);
    raise_cell(storage, 2u * texel, ~key);
    raise_cell(storage, 2u * texel + 1u, key);
  }
}

/// The range. Not concurrent with extend().
template <cell_storage Storage>
[[nodiscard]] depth_range load(const Storage& storage, std::uint32_t texel) noexcept {
  return depth_range{~storage.load(2u * texel, std::memory_order_relaxed),
                     storage.load(2u * texel + 1u, std::memory_order_relaxed)};
}

}  // namespace atomic_depth_range

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
