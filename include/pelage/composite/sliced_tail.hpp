// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/tail.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/visibility/layer_position.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// A tail for each of some slices of depth: keeps the order of slices, which one tail drops, and drops only the order
/// within a slice. Depends on the set of fragments alone, bit for bit. 20 · Slices bytes.
///
/// The slices divide a range that is known before the fragments are, such as that of all fibres' points in the view:
/// it may be wide of the pixel's own, which costs slices, or too narrow, which puts what lies beyond an end into the
/// slice there. Exact where no slice holds two fragments, and where those of each slice have one colour; a slice's
/// colour is never outside of the hull of its fragments'. Both except for rounding, as tail tells it: an alpha of 2⁻²⁰
/// leaves a colour one bit, and adds as little. Which number is enough is measured in bench/README.md. For many threads
/// each slice is a texel of an atomic_tail: pixel · Slices + layer_at(position).
template <std::uint32_t Slices = 16u>
struct sliced_tail {
  static_assert(Slices > 0u, "pelage::sliced_tail<Slices>: at least one slice");

  std::array<tail, Slices> slice;  ///< nearest first

  /// Slices that hold nothing.
  [[nodiscard]] static constexpr sliced_tail<Slices> empty() noexcept {
    sliced_tail<Slices> none;
    for (std::uint32_t i = 0u; i < Slices; ++i) {
      none.slice[i] = empty_tail();
    }
    return none;
  }

  /// Puts a fragment in. `position`: slice_position(relative depth, Slices), [0, Slices]. `alpha` and `colour` as for
  /// add_fragment(). Any order of calls gives the same slices. O(1).
  inline void add(float position, float alpha, const glm::vec3& colour) noexcept {
    const std::uint32_t at = layer_at(position, Slices);
    slice[at] = add_fragment(slice[at], alpha, colour);
  }

  /// Puts other slices of the same range in. Associative and commutative, empty() is the identity.
  constexpr void merge(const sliced_tail<Slices>& other) noexcept {
    for (std::uint32_t i = 0u; i < Slices; ++i) {
      slice[i] = pelage::merge(slice[i], other.slice[i]);
    }
  }
};

/// The pixel with all slices behind its fibres, nearest first, each as add_tail() adds one. O(Slices).
template <std::uint32_t Slices>
[[nodiscard]] inline pixel_radiance<float> add_sliced_tail(const pixel_radiance<float>& pixel,
                                                           const sliced_tail<Slices>& behind) noexcept {
  pixel_radiance<float> sum = pixel;
  for (std::uint32_t i = 0u; i < Slices; ++i) {
    sum = add_tail(sum, behind.slice[i]);
  }
  return sum;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
