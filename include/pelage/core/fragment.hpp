// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/version.hpp>

#include <bit>
#include <cstdint>
#include <limits>

namespace pelage::inline PELAGE_ABI {

/// What one fibre leaves in one pixel: where it lies and who it is. Everything else (colour, tangent,
/// coverage) is the caller's, found again through `id`. 8 bytes.
///
/// Fragments have a total order: depth, then id. Structures built from the same set of fragments end in
/// the same state whatever the order of arrival, so an id must name a primitive, never a pool slot.
struct fragment {
  float depth;       ///< distance from the eye along the view, any value but NaN; -0 ties with +0
  std::uint32_t id;  ///< the caller's stable number, unique among the fragments of a pixel, [0, 2^32 - 1)
};

/// The fragment that stands for none: behind every other one, an id that no primitive has.
[[nodiscard]] constexpr fragment no_fragment() noexcept {
  return fragment{std::numeric_limits<float>::infinity(), 0xffffffffu};
}

/// False for what every structure refuses: a NaN depth, or the id of no_fragment().
[[nodiscard]] constexpr bool is_fragment(fragment f) noexcept;

/// The total order: true if `a` is nearer than `b`, or as near with the smaller id. It compares depth_key(), not
/// floats: denormals count on machines that flush them, too, and a NaN lies beyond the infinity of its sign.
[[nodiscard]] constexpr bool before(fragment a, fragment b) noexcept;

/// An unsigned number that orders as the depth does: key(a) < key(b) exactly when a < b. -0 and +0 share a
/// key, infinities are ordinary, denormals count. NaN has a key outside [key(-inf), key(+inf)].
[[nodiscard]] constexpr std::uint32_t depth_key(float depth) noexcept;

/// True if both are the same fragment: neither is before the other.
[[nodiscard]] constexpr bool same(fragment a, fragment b) noexcept {
  return depth_key(a.depth) == depth_key(b.depth) && a.id == b.id;
}

/// The depth whose key this is; the inverse of depth_key except for the sign of zero.
[[nodiscard]] constexpr float depth_from_key(std::uint32_t key) noexcept;

// ---------------------------------------------------------------------------------------------------------

constexpr bool is_fragment(fragment f) noexcept {
  const std::uint32_t magnitude = std::bit_cast<std::uint32_t>(f.depth) & 0x7fffffffu;
  return magnitude <= 0x7f800000u && f.id != 0xffffffffu;
}

constexpr bool before(fragment a, fragment b) noexcept {
  const std::uint32_t key_a = depth_key(a.depth);
  const std::uint32_t key_b = depth_key(b.depth);
  return key_a < key_b || (key_a == key_b && a.id < b.id);
}

constexpr std::uint32_t depth_key(float depth) noexcept {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(depth);
  const bool negative = (bits & 0x80000000u) != 0u;
  const std::uint32_t flipped = negative ? ~bits : bits | 0x80000000u;
  return bits == 0x80000000u ? 0x80000000u : flipped;
}

constexpr float depth_from_key(std::uint32_t key) noexcept {
  const bool negative = (key & 0x80000000u) == 0u;
  return std::bit_cast<float>(negative ? ~key : key & 0x7fffffffu);
}

}  // namespace pelage
