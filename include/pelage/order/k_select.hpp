// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/lanes.hpp>
#include <pelage/order/long_list.hpp>
#include <pelage/order/nearest_keys.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// Writes the K first of the total order, nearest first, and returns how many there are: K, or all that
/// is_fragment() accepts where those are fewer; no_fragment() fills the rest. The same bits as inserting the list
/// into a k_buffer<K> and sorting it, for every depth and every setting of the floating-point unit, denormals-are-zero
/// included. What is left behind is what is_fragment() refuses and what nearest[K - 1] is before().
///
/// `list`: any length, any order, ids unique. Must not overlap `nearest`. K in [1, 64].
///
/// A first pass takes the least depth of each of 2 K columns of the list; the K-th least of those bounds the K nearest,
/// and in a list in no particular order about 1.4 K fragments lie within it, whatever its length. A second pass copies
/// them, for K up to 8 from those blocks of 64 alone that have some, and a network sorts them. Lists that defeat the
/// bound tighten it as they go. O(n + K log² K) operations, at worst O(n log² K), with a constant of 1 / lanes. Lists
/// with a -0 or a refused id among the near ones are selected by insertion, O(n K). No allocation; at most 6 KiB of
/// stack, without any optimisation (-O0) up to 1 MiB.
template <std::uint32_t K, vector_isa Isa = widest_isa>
std::uint32_t k_select(std::span<const fragment> list, std::span<fragment, K> nearest) noexcept;

/// k_select for every pixel of a resolved A-buffer. The fragments of pixel p are those from first[p] up to
/// first[p + 1]; its nearest go to nearest[p K] and on.
///
/// `first`: one more than there are pixels (or empty), ascending, none beyond the fragments. `nearest`: K a pixel.
/// Four long lists at a time, one's latency hidden behind the others': faster than a call for each. At most 16 KiB of
/// stack, or 1 MiB as above.
template <std::uint32_t K, vector_isa Isa = widest_isa>
void k_select(std::span<const fragment> fragments, std::span<const std::uint32_t> first,
              std::span<fragment> nearest) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// k_select by the network for K, which is a power of two, of which the `k` first are written, from more than 2 K
/// fragments. Not inlined, nor is the next: select_nearest() has no frame of its own under that of a lesser network.
template <std::uint32_t K, vector_isa Isa>
[[gnu::noinline]] std::uint32_t select_from_many(const fragment* list, std::size_t n, fragment* nearest,
                                                 std::uint32_t k) noexcept {
  long_list<K, Isa> one;
  one.start(list, n, k);
  one.gather();
  return one.finish(nearest, k);
}

/// The same from at most 2 K.
template <std::uint32_t K, vector_isa Isa>
[[gnu::noinline]] std::uint32_t select_from_few(const fragment* list, std::size_t n, fragment* nearest,
                                                std::uint32_t k) noexcept {
  nearest_keys<K, Isa> best;
  std::size_t from = 0u;
  for (; from + K <= n; from += K) {
    best.absorb(list + from);
  }
  if (from < n || n == 0u) {
    fragment rest[K];
    std::fill(std::copy(list + from, list + n, rest), rest + K, blank());
    best.absorb(rest);
  }
  return best.is_inexact() ? select_by_insertion(list, n, nearest, k) : best.write(nearest, k);
}

/// The same from any number, by the least network that will do.
template <std::uint32_t K, vector_isa Isa>
std::uint32_t select_nearest(const fragment* list, std::size_t n, fragment* nearest, std::uint32_t k) noexcept {
  if (n > 2u * K) {
    return select_from_many<K, Isa>(list, n, nearest, k);
  }
  if constexpr (K > 8u) {
    if (n <= K / 2u) {
      const std::uint32_t half = std::min(k, K / 2u);
      std::fill(nearest + half, nearest + k, no_fragment());
      return select_nearest<K / 2u, Isa>(list, n, nearest, half);
    }
  }
  return select_from_few<K, Isa>(list, n, nearest, k);
}

/// k_select for many lists.
template <std::uint32_t K, vector_isa Isa>
void select_each(const fragment* fragments, const std::uint32_t* first, std::size_t lists, fragment* nearest,
                 std::uint32_t k) noexcept {
  constexpr std::size_t together = 4u;
  constexpr std::size_t cached = 2048u;  // 16 KiB: fragments that are still near when they are read again
  long_list<K, Isa> side_by_side[together];
  const auto length = [&](std::size_t p) { return std::size_t{first[p + 1u]} - first[p]; };
  std::size_t p = 0u;
  while (p < lists) {
    std::size_t long_ones = 0u;
    while (long_ones < together && p + long_ones < lists && length(p + long_ones) > 2u * K &&
           (long_ones == 0u || first[p + long_ones + 1u] - first[p] <= cached)) {
      ++long_ones;
    }
    for (std::size_t i = 0u; i < long_ones; ++i) {
      side_by_side[i].start(fragments + first[p + i], length(p + i), k);
    }
    for (std::size_t i = 0u; i < long_ones; ++i) {
      side_by_side[i].gather();
    }
    for (std::size_t i = 0u; i < long_ones; ++i) {
      side_by_side[i].finish(nearest + (p + i) * k, k);
    }
    p += long_ones;
    if (long_ones == 0u) {
      select_nearest<K, Isa>(fragments + first[p], length(p), nearest + p * k, k);
      ++p;
    }
  }
}

/// The size of the network for K.
template <std::uint32_t K>
inline constexpr std::uint32_t network_size = std::max(8u, std::bit_ceil(K));

}  // namespace detail

template <std::uint32_t K, vector_isa Isa>
std::uint32_t k_select(std::span<const fragment> list, std::span<fragment, K> nearest) noexcept {
  static_assert(K >= 1u && K <= 64u, "pelage::k_select<K>: K must be in [1, 64]");
  return detail::select_nearest<detail::network_size<K>, Isa>(list.data(), list.size(), nearest.data(), K);
}

template <std::uint32_t K, vector_isa Isa>
void k_select(std::span<const fragment> fragments, std::span<const std::uint32_t> first,
              std::span<fragment> nearest) noexcept {
  static_assert(K >= 1u && K <= 64u, "pelage::k_select<K>: K must be in [1, 64]");
  const std::size_t lists = first.empty() ? 0u : first.size() - 1u;
  PELAGE_ASSERT(nearest.size() >= lists * K);
  PELAGE_ASSERT(first.empty() || first.back() <= fragments.size());
  detail::select_each<detail::network_size<K>, Isa>(fragments.data(), first.data(), lists, nearest.data(), K);
}

}  // namespace pelage
