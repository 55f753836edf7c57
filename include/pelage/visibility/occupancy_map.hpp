// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/visibility/layer_position.hpp>

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

namespace detail {

/// The bits below bit n; all for n >= 32.
[[nodiscard]] constexpr std::uint32_t bits_below(std::uint32_t n) noexcept {
  return n < 32u ? (1u << n) - 1u : 0xffffffffu;
}

}  // namespace detail

/// One texel of an occupancy map: a bit for each slice of its depth range and a sum for each slab of slices, from
/// which a fragment's place in the depth order is estimated without sorting. [Sintorn & Assarsson 2009, §3]
///
/// Keeps which slices hold anything and what each slab holds; drops how much lies in each slice of a slab. Depends on
/// the set of fragments alone, bit for bit. Sums count fragments, or whatever `amount` the caller gives, such as
/// optical_depth(alpha), which transmittance_of() reads back; they stop at 2³² - 1. Slices / 8 + 4 · Slabs bytes: 32 at
/// 128 slices and 4 slabs, 40 with the depth_range. An opaque object's limit cuts fragments before they come here; what
/// lies behind the range is shadowed by all slabs.
template <std::uint32_t Slices = 128u, std::uint32_t Slabs = 4u>
struct occupancy_map {
  static_assert(Slices % 32u == 0u && Slices > 0u, "pelage::occupancy_map: Slices must be a multiple of 32");
  static_assert(Slabs > 0u && Slices % Slabs == 0u, "pelage::occupancy_map: all Slabs must have as many slices");
  static_assert(Slabs <= 32u, "pelage::occupancy_map: at most 32 Slabs, whose sums' ends are bits of one cell");
  static_assert(Slices / Slabs % 32u == 0u || 32u % (Slices / Slabs) == 0u,
                "pelage::occupancy_map: a slab must be whole words of 32 slices, or lie inside one");

  static constexpr std::uint32_t words = Slices / 32u;          ///< of slice bits a texel
  static constexpr std::uint32_t cells = words + Slabs + 1u;    ///< a texel, for a cell_storage
  static constexpr std::uint32_t slab_slices = Slices / Slabs;  ///< slices a slab

  std::array<std::uint32_t, words> occupied;  ///< slice i is bit i % 32 of word i / 32
  std::array<std::uint32_t, Slabs> amount;    ///< the sum of each slab

  /// A texel without fragments.
  [[nodiscard]] static constexpr occupancy_map<Slices, Slabs> empty() noexcept {
    occupancy_map<Slices, Slabs> map;
    for (std::uint32_t i = 0u; i < words; ++i) {
      map.occupied[i] = 0u;
    }
    for (std::uint32_t i = 0u; i < Slabs; ++i) {
      map.amount[i] = 0u;
    }
    return map;
  }

  /// Puts a fragment in. `position`: slice_position(relative depth, Slices), [0, Slices]. `added`: 1 to count
  /// fragments. Not concurrent (see atomic_occupancy_map). O(1).
  constexpr void add(float position, std::uint32_t added) noexcept {
    const std::uint32_t slice = layer_at(position, Slices);
    const std::uint32_t word = occupied[slice / 32u];
    occupied[slice / 32u] = word | (1u << (slice % 32u));
    amount[slice / slab_slices] = add_saturating(amount[slice / slab_slices], added);
  }

  /// Puts another map of the same depth range in. Associative and commutative, empty() is the identity.
  constexpr void merge(const occupancy_map<Slices, Slabs>& other) noexcept {
    for (std::uint32_t i = 0u; i < words; ++i) {
      occupied[i] = occupied[i] | other.occupied[i];
    }
    for (std::uint32_t i = 0u; i < Slabs; ++i) {
      amount[i] = add_saturating(amount[i], other.amount[i]);
    }
  }

  /// The sum of all slabs.
  [[nodiscard]] constexpr std::uint32_t total() const noexcept {
    std::uint32_t sum = 0u;
    for (std::uint32_t i = 0u; i < Slabs; ++i) {
      sum = add_saturating(sum, amount[i]);
    }
    return sum;
  }

  /// The estimate of what lies before a position, [0, total()]; with counted fragments the position's place in their
  /// order. The slabs before it count whole, its own slab by the share of its set slices that lie before, the slice
  /// itself linearly. [Sintorn & Assarsson 2009, §3.2] Never falls as the position grows; exact at the ends of slabs
  /// (sums from 2²⁴ on by a float's own precision); 0 at 0 and total() at Slices. O(Slices / Slabs / 32 + Slabs).
  [[nodiscard]] constexpr float amount_before(float position) const noexcept;

  /// The same for a fragment that is in the map itself, which must not lie before itself: what lies before its slice,
  /// for the farthest fragment, too, at whose position amount_before() is total(). 0 in the nearest slice that is set.
  [[nodiscard]] constexpr float amount_before_fragment(float position) const noexcept {
    return amount_before(static_cast<float>(layer_at(position, Slices)));
  }

  /// The paper's own order of a fragment that is in the map [Sintorn & Assarsson 2009, §3.2]: across its slice, linear
  /// from what lies before the slice in front to what lies before its own. Nearer to the truth than the whole slices of
  /// amount_before_fragment() in dense hair, where slices hold many; those are nearer where most hold none or one, and
  /// exact where none holds two (bench/README.md). 0 up to position 1; never greater than
  /// amount_before_fragment().
  [[nodiscard]] constexpr float interpolated_before_fragment(float position) const noexcept {
    return amount_before(position > 1.0f ? position - 1.0f : 0.0f);
  }
};

/// A texel that many threads fill at once: cells [texel · Map::cells, (texel + 1) · Map::cells) of the storage, all 0
/// at first, for Map = occupancy_map<Slices, Slabs>; the last holds the ends of the sums (add_and_mark).
namespace atomic_occupancy_map {

/// occupancy_map::add(). Wait-free where the hardware has the changes; memory orders: core/atomic_cells.hpp.
template <class Map, cell_storage Storage>
void add(Storage& storage, std::uint32_t texel, float position, std::uint32_t added) noexcept {
  PELAGE_ASSERT(texel < storage.size() / Map::cells);
  const std::uint32_t slice = layer_at(position, Map::words * 32u);
  const std::uint32_t first = texel * Map::cells;
  set_bits(storage, first + slice / 32u, 1u << (slice % 32u));
  const std::uint32_t slab = slice / Map::slab_slices;
  add_and_mark(storage, first + Map::words + slab, added, first + Map::cells - 1u, 1u << slab);
}

/// The texel. Not concurrent with add().
template <class Map, cell_storage Storage>
[[nodiscard]] Map load(const Storage& storage, std::uint32_t texel) noexcept {
  const std::uint32_t first = texel * Map::cells;
  Map map = Map::empty();
  for (std::uint32_t i = 0u; i < Map::words; ++i) {
    map.occupied[i] = storage.load(first + i, std::memory_order_relaxed);
  }
  for (std::uint32_t i = 0u; i < Map::cells - Map::words - 1u; ++i) {
    map.amount[i] = load_marked(storage, first + Map::words + i, first + Map::cells - 1u, 1u << i);
  }
  return map;
}

}  // namespace atomic_occupancy_map

// ---------------------------------------------------------------------------------------------------------

template <std::uint32_t Slices, std::uint32_t Slabs>
constexpr float occupancy_map<Slices, Slabs>::amount_before(float position) const noexcept {
  const std::uint32_t slice = layer_at(position, Slices);
  const std::uint32_t slab = slice / slab_slices;
  std::uint32_t before = 0u;
  for (std::uint32_t i = 0u; i < Slabs; ++i) {
    before = add_saturating(before, i < slab ? amount[i] : 0u);
  }
  const std::uint32_t first = slab * slab_slices;  // slice, and where in its word a slab smaller than that begins
  const std::uint32_t of_slab = detail::bits_below(slab_slices) << (first % 32u);
  std::uint32_t set_before = 0u;
  std::uint32_t set = 0u;
  for (std::uint32_t i = 0u; i < (slab_slices + 31u) / 32u; ++i) {
    const std::uint32_t word_first = (first / 32u + i) * 32u;
    const std::uint32_t bits = occupied[first / 32u + i] & of_slab;
    const std::uint32_t below = slice > word_first ? detail::bits_below(slice - word_first) : 0u;
    set_before += static_cast<std::uint32_t>(std::popcount(bits & below));
    set += static_cast<std::uint32_t>(std::popcount(bits));
  }
  const std::uint32_t here = (occupied[slice / 32u] >> (slice % 32u)) & 1u;
  const float inside = static_cast<float>(here) * (position - static_cast<float>(slice));
  const float share = set > 0u ? (static_cast<float>(set_before) + inside) / static_cast<float>(set) : 0.0f;
  // Rounding may not lift the sum beyond what the next slab begins with.
  const float most = static_cast<float>(add_saturating(before, amount[slab]));
  const float sum = static_cast<float>(before) + share * static_cast<float>(amount[slab]);
  return sum < most ? sum : most;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
