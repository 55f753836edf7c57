// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/lane_moves.hpp>
#include <pelage/core/lanes.hpp>
#include <pelage/order/lane_network.hpp>
#include <pelage/order/nearest_keys.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
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
/// them, and a network sorts them. Lists that defeat the bound tighten it as they go. O(n + K log² K) operations, at
/// worst O(n log² K), with a constant of 1 / lanes. Lists with a -0 or a refused id among the near ones are
/// selected by insertion, O(n K). No allocation; at most 6 KiB of stack, without any
/// optimisation (-O0) up to 1 MiB.
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

/// One list of more than 2 K fragments on its way: start(), gather(), finish().
template <std::uint32_t K, vector_isa Isa>
class long_list {
 public:
  /// Finds the bound.
  [[gnu::always_inline]] inline void start(const fragment* list, std::size_t n) noexcept;
  /// Copies what is within it.
  [[gnu::always_inline]] inline void gather() noexcept;
  /// Sorts that.
  [[gnu::always_inline]] inline std::uint32_t finish(fragment* nearest, std::uint32_t k) noexcept;

 private:
  static constexpr std::uint32_t width = lane_width(Isa);
  using depths = lanes<width>;
  static constexpr std::uint32_t block = 64u;
  static constexpr std::uint32_t burst = 8u;

  /// The depths of `width` fragments, Source(i) the number of lane i's in two vectors of depths and ids.
  template <auto Source>
  [[nodiscard, gnu::always_inline]] static inline depths depths_of(const fragment* f) noexcept {
    depths low, high;
    std::memcpy(&low.lane, f, sizeof low.lane);
    std::memcpy(&high.lane, f + width / 2u, sizeof high.lane);
    return shuffled<Source>(low, high);
  }
  /// Bit i is set where the depth of fragment i of `width` is at most the bound, clear where it is NaN. Where the
  /// caller has set denormals-are-zero, every denormal counts as 0, here and in the bound.
  [[nodiscard, gnu::always_inline]] static inline std::uint32_t within(const fragment* f, depths bound) noexcept;
  /// Bit i is set where fragment base + i of the list is within the bound.
  [[nodiscard, gnu::always_inline]] inline std::uint64_t near_in_block(std::size_t base) const noexcept;
  /// Absorbs what was copied and takes the bound from it.
  [[gnu::noinline]] void tighten() noexcept;

  const fragment* list_;
  std::size_t n_;
  float bound_;
  std::size_t count_;  ///< copied to kept_
  nearest_keys<K, Isa> best_;
  alignas(64) fragment kept_[3u * K + block + burst];
};

template <std::uint32_t K, vector_isa Isa>
inline void long_list<K, Isa>::start(const fragment* list, std::size_t n) noexcept {
  constexpr std::uint32_t rows = 2u * K / width;
  // Not in order, which takes one instruction less.
  constexpr auto source = [](int i) { return i / 4 * 4 + 2 * (i % 2) + (i % 4 < 2 ? 0 : int{width}); };
  depths nearest[rows];
  unroll<rows>([&](auto r)
                   __attribute__((always_inline)) { nearest[r] = depths(std::numeric_limits<float>::infinity()); });
  const auto lower = [&](auto r, std::size_t i) __attribute__((always_inline)) {
    nearest[r] = least(depths_of<source>(list + i + r * width), nearest[r]);  // of a NaN, the second
  };
  std::size_t i = 0u;
  for (; i + 2u * K <= n; i += 2u * K) {
    unroll<rows>([&](auto r) __attribute__((always_inline)) { lower(r, i); });
  }
  // What does not fill a vector at the end is left out: a bound from fewer fragments is still one.
  unroll<rows - 1u>([&](auto r) __attribute__((always_inline)) {
    if (i + (r + 1u) * width <= n) {
      lower(r, i);
    }
  });
  list_ = list;
  n_ = n;
  bound_ = lane_network::lower_median(nearest);
  count_ = 0u;
  best_.clear();
}

template <std::uint32_t K, vector_isa Isa>
inline void long_list<K, Isa>::gather() noexcept {
  for (std::size_t base = 0u; base < n_; base += block) {
    std::uint64_t near = near_in_block(base);
    fragment* to = kept_ + count_;
    count_ += static_cast<std::size_t>(std::popcount(near));
    while (near != 0u) {  // in bursts, since a branch for each costs more than a few copies in vain
      unroll<burst>([&](auto j) __attribute__((always_inline)) {
        to[j] = list_[base + (static_cast<std::uint32_t>(std::countr_zero(near)) & 63u)];
        near &= near - 1u;
      });
      to += burst;
    }
    if (count_ > 2u * K) [[unlikely]] {
      tighten();
    }
  }
  std::fill_n(kept_ + count_, K, blank());
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint32_t long_list<K, Isa>::within(const fragment* f, depths bound) noexcept {
  constexpr auto even = [](int i) { return 2 * i; };
  const depths depth = depths_of<even>(f);
#if defined(__AVX512F__)
  if constexpr (Isa == vector_isa::avx512) {  // bits() takes two instructions more
    return _mm512_cmp_ps_mask(__m512(depth.lane), __m512(bound.lane), _CMP_LE_OQ);
  }
#endif
  return bits(depth <= bound);
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint64_t long_list<K, Isa>::near_in_block(std::size_t base) const noexcept {
  const depths limit(bound_);
  std::uint64_t near = 0u;
  if (base + block <= n_) {
    unroll<block / width>([&](auto v) __attribute__((always_inline)) {
      constexpr std::uint32_t first = v * width;
      near |= std::uint64_t{within(list_ + base + first, limit)} << first;
    });
  } else {
    // The last vector looks back at fragments already seen; the shift drops their bits.
    for (std::size_t i = base; i < n_; i += width) {
      const std::size_t first = std::min(i, n_ - width);
      near |= std::uint64_t{within(list_ + first, limit)} >> (i - first) << (i - base);
    }
  }
  return near;
}

template <std::uint32_t K, vector_isa Isa>
void long_list<K, Isa>::tighten() noexcept {
  std::size_t from = 0u;
  for (; from + K <= count_; from += K) {
    best_.absorb(kept_ + from);
  }
  count_ -= from;
  std::copy_n(kept_ + from, count_, kept_);
  bound_ = std::min(bound_, best_.bound());
}

/// The same by insertion, for a list that has what keys cannot tell. Compares integers, not floats: exact with
/// denormals-are-zero too.
[[gnu::noinline]] inline std::uint32_t select_by_insertion(const fragment* list, std::size_t n, fragment* nearest,
                                                           std::uint32_t k) noexcept {
  const auto order = [](fragment f) { return std::uint64_t{depth_key(f.depth)} << 32 | f.id; };
  std::uint32_t held = 0u;
  for (std::size_t i = 0u; i < n; ++i) {
    const bool enters = is_fragment(list[i]) && (held < k || order(list[i]) < order(nearest[k - 1u]));
    if (enters) {
      held = std::min(held + 1u, k);
      std::uint32_t place = held - 1u;
      for (; place > 0u && order(list[i]) < order(nearest[place - 1u]); --place) {
        nearest[place] = nearest[place - 1u];
      }
      nearest[place] = list[i];
    }
  }
  std::fill(nearest + held, nearest + k, no_fragment());
  return held;
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint32_t long_list<K, Isa>::finish(fragment* nearest, std::uint32_t k) noexcept {
  for (std::size_t from = 0u; from < count_ || best_.is_empty(); from += K) {
    best_.absorb(kept_ + from);
  }
  return best_.is_inexact() ? select_by_insertion(list_, n_, nearest, k) : best_.write(nearest, k);
}

/// k_select by the network for K, which is a power of two, of which the `k` first are written, from more than 2 K
/// fragments. Not inlined, nor is the next: select_nearest() has no frame of its own under that of a lesser network.
template <std::uint32_t K, vector_isa Isa>
[[gnu::noinline]] std::uint32_t select_from_many(const fragment* list, std::size_t n, fragment* nearest,
                                                 std::uint32_t k) noexcept {
  long_list<K, Isa> one;
  one.start(list, n);
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
  long_list<K, Isa> side_by_side[together];
  const auto length = [&](std::size_t p) { return std::size_t{first[p + 1u]} - first[p]; };
  std::size_t p = 0u;
  while (p < lists) {
    std::size_t long_ones = 0u;
    while (long_ones < together && p + long_ones < lists && length(p + long_ones) > 2u * K) {
      ++long_ones;
    }
    for (std::size_t i = 0u; i < long_ones; ++i) {
      side_by_side[i].start(fragments + first[p + i], length(p + i));
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
