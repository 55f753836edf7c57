// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/visibility/occupancy_map.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace pelage::inline PELAGE_ABI {

/// occupancy_map::amount_before for many positions in one texel, bit for bit: what all look-ups share is computed
/// once, and the rest is a loop without branches that a compiler turns into vectors (GCC 12 only where it is not
/// inlined into a loop of the caller's). For the CPU.
///
/// `positions`: [0, Slices] each. `amounts`: as long, may be the same memory. O(Slices / 32 + Slabs + n).
template <std::uint32_t Slices, std::uint32_t Slabs>
void amounts_before(const occupancy_map<Slices, Slabs>& map, std::span<const float> positions,
                    std::span<float> amounts) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// The k-th of a few numbers, from their differences to the one before and without a look-up in memory: a compiler
/// keeps those in registers, where it would gather from a table.
template <std::size_t N>
[[nodiscard]] constexpr std::uint32_t sum_of_first(const std::array<std::uint32_t, N>& difference,
                                                   std::uint32_t k) noexcept {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return (0u + ... + (k >= I ? difference[I] : 0u));
  }
  (std::make_index_sequence<N>());
}

}  // namespace detail

template <std::uint32_t Slices, std::uint32_t Slabs>
void amounts_before(const occupancy_map<Slices, Slabs>& map, std::span<const float> positions,
                    std::span<float> amounts) noexcept {
  static_assert(Slices < 65536u, "pelage::amounts_before: slices are counted in 16 bits");
  PELAGE_ASSERT(positions.size() == amounts.size());
  // Parts that lie in one word and one slab; a position needs to know its part alone.
  constexpr std::uint32_t slab_slices = Slices / Slabs;
  constexpr std::uint32_t part_slices = slab_slices < 32u ? slab_slices : 32u;
  constexpr std::uint32_t parts = Slices / part_slices;
  using table = std::array<std::uint32_t, parts>;
  table bits;    // the part's slices, from bit 0 on
  table set;     // set slices of its slab, at least 1, and from bit 16 on those before the part
  table before;  // the slabs before, as a float's bits
  table here;    // its slab, as a float's bits
  table most;    // both, as a float's bits
  std::uint32_t sum = 0u;
  for (std::uint32_t slab = 0u; slab < Slabs; ++slab) {
    constexpr std::uint32_t slab_parts = slab_slices / part_slices;
    const std::uint32_t next = add_saturating(sum, map.amount[slab]);
    std::uint32_t count = 0u;
    for (std::uint32_t part = slab * slab_parts; part < (slab + 1u) * slab_parts; ++part) {
      const std::uint32_t first = part * part_slices;
      bits[part] = (map.occupied[first / 32u] >> (first % 32u)) & detail::bits_below(part_slices);
      set[part] = count << 16u;
      before[part] = std::bit_cast<std::uint32_t>(static_cast<float>(sum));
      here[part] = std::bit_cast<std::uint32_t>(static_cast<float>(map.amount[slab]));
      most[part] = std::bit_cast<std::uint32_t>(static_cast<float>(next));
      count += static_cast<std::uint32_t>(std::popcount(bits[part]));
    }
    for (std::uint32_t part = slab * slab_parts; part < (slab + 1u) * slab_parts; ++part) {
      set[part] += count > 0u ? count : 1u;
    }
    sum = next;
  }
  const auto differences = [](table& t) {
    for (std::uint32_t i = parts - 1u; i > 0u; --i) {
      t[i] -= t[i - 1u];
    }
  };
  differences(bits);
  differences(set);
  differences(before);
  differences(here);
  differences(most);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const float position = positions[i];
    const std::uint32_t truncated = static_cast<std::uint32_t>(static_cast<std::int32_t>(position));
    const std::uint32_t slice = truncated < Slices ? truncated : Slices - 1u;
    const std::uint32_t part = slice / part_slices;
    const std::uint32_t slices = detail::sum_of_first(bits, part)
                                 << (31u - slice % part_slices);  // this one at the top
    const std::uint32_t counts = detail::sum_of_first(set, part);
    const float inside = static_cast<float>(slices >> 31u) * (position - static_cast<float>(slice));
    const std::uint32_t set_here = static_cast<std::uint32_t>(std::popcount(slices << 1u));
    const float set_before = static_cast<float>((counts >> 16u) + set_here);
    const float share = (set_before + inside) / static_cast<float>(counts & 0xffffu);
    const float amount = std::bit_cast<float>(detail::sum_of_first(before, part)) +
                         share * std::bit_cast<float>(detail::sum_of_first(here, part));
    const float at_most = std::bit_cast<float>(detail::sum_of_first(most, part));
    amounts[i] = amount < at_most ? amount : at_most;
  }
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
