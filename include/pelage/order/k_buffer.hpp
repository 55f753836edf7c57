// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/order/sorting_network.hpp>

#include <array>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// The K fragments of one pixel nearest the eye, by select-and-replace. [Yu12 §5.1, second pass]
///
/// Keeps the K first of the total order; drops nothing silently, since insert() hands back what falls out, where the
/// paper leaves it out. After sort() its state depends on the set of fragments alone, not on their order of arrival:
/// ties in depth go to the smaller id. Not concurrent: one thread builds it (atomic_k_buffer.hpp is for many). 8 K + 12
/// bytes. K in [1, 64].
template <std::uint32_t K>
struct k_buffer {
  static_assert(K >= 1u && K <= 64u, "pelage::k_buffer<K>: K must be in [1, 64]");

  std::array<fragment, K> slot;  ///< in no order before sort(); empty slots hold no_fragment()
  fragment farthest;             ///< the last of the slots in the total order; no_fragment() until all are taken
  std::uint32_t farthest_slot;   ///< where it lies, [0, K)

  /// A buffer that holds nothing.
  [[nodiscard]] static constexpr k_buffer empty() noexcept {
    k_buffer<K> none;
    for (std::uint32_t i = 0u; i < K; ++i) {
      none.slot[i] = no_fragment();
    }
    none.farthest = no_fragment();
    none.farthest_slot = 0u;
    return none;
  }

  /// Offers a fragment and returns what fell out: the fragment that it pushed out, itself where K nearer ones are
  /// held, or no_fragment(). What is_fragment() refuses comes back as it is. For a tail, look up alpha and colour by
  /// the id that comes back, not by the one offered. O(1) when the fragment is too far, O(K) when it stays.
  [[nodiscard]] constexpr fragment insert(fragment offered) noexcept {
    if (!is_fragment(offered) || !before(offered, farthest)) {
      return offered;
    }
    const fragment lost = farthest;
    for (std::uint32_t i = 0u; i < K; ++i) {
      if (i == farthest_slot) {
        slot[i] = offered;
      }
    }
    find_farthest();
    return lost;
  }

  /// Takes the K nearest of both; what fell out is left in `other`, which is a valid buffer again. `other` must not
  /// be this buffer. Associative and commutative in what is kept, with empty() as identity, so partial results of
  /// several workers combine in any order. O(K²).
  constexpr void merge(k_buffer& other) noexcept {
    PELAGE_ASSERT(this != &other);
    for (std::uint32_t i = 0u; i < K; ++i) {
      const fragment lost = insert(other.slot[i]);
      other.slot[i] = lost;
    }
    other.find_farthest();
  }

  /// Puts the slots in the total order, nearest first, empty ones last. O(K log² K).
  constexpr void sort() noexcept {
    sort_network<K>(slot);
    farthest = slot[K - 1u];
    farthest_slot = K - 1u;
  }

  /// Fragments held, [0, K]. O(K).
  [[nodiscard]] constexpr std::uint32_t size() const noexcept {
    std::uint32_t held = 0u;
    for (std::uint32_t i = 0u; i < K; ++i) {
      held += is_fragment(slot[i]) ? 1u : 0u;
    }
    return held;
  }

  /// Finds the farthest slot anew, for whoever wrote to the slots. O(K).
  constexpr void find_farthest() noexcept {
    farthest = slot[0];
    farthest_slot = 0u;
    for (std::uint32_t i = 1u; i < K; ++i) {
      const bool farther = before(farthest, slot[i]);
      farthest = farther ? slot[i] : farthest;
      farthest_slot = farther ? i : farthest_slot;
    }
  }
};

}  // namespace pelage
