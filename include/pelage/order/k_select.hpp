// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/lane_network.hpp>
#include <pelage/order/vector_lanes.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace pelage {

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
/// worst O(n log² K), with a constant of 1 / lanes. Lists with a -0 or a refused id among the near ones go through
/// k_buffer, O(n K). No allocation; at most 4 KiB of stack.
template <std::uint32_t K, vector_isa Isa = widest_isa>
std::uint32_t k_select(std::span<const fragment> list, std::span<fragment, K> nearest) noexcept;

/// k_select for every pixel of a resolved A-buffer. The fragments of pixel p are those from first[p] up to
/// first[p + 1]; its nearest go to nearest[p K] and on.
///
/// `first`: one more than there are pixels (or empty), ascending, none beyond the fragments. `nearest`: K a pixel.
/// Four long lists at a time, one's latency hidden behind the others': faster than a call for each. At most 12 KiB of
/// stack.
template <std::uint32_t K, vector_isa Isa = widest_isa>
void k_select(std::span<const fragment> fragments, std::span<const std::uint32_t> first,
              std::span<fragment> nearest) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// Depths within a pixel's lists as a float's bits: that of a place that holds no fragment, a NaN behind +inf.
inline constexpr std::uint32_t blank_depth = 0x7f800001u;

/// A key is a fragment as a double that orders as before() does: the depth's bits above, the id below (its complement
/// where the depth is negative). `key_offset` is added to the depth's bits, and makes each key a normal double, so
/// that no setting of the floating-point unit flushes one to zero; even +inf stays below the doubles' infinity.
inline constexpr std::uint32_t key_offset = 0x00100000u;

/// The key of a fragment given by its depth's bits; that of no fragment where the depth is NaN. -0 gives no good key.
[[nodiscard]] inline std::uint64_t key_of(std::uint32_t depth, std::uint32_t id) noexcept;

/// The fragment whose key this is.
[[nodiscard]] inline fragment fragment_of(std::uint64_t key) noexcept;

/// Stands in a list for no fragment.
[[nodiscard]] inline fragment blank() noexcept;

/// The K nearest of what was absorbed, sorted. K: a power of two from 8 on.
template <std::uint32_t K, vector_isa Isa>
class nearest_keys {
 public:
  /// Takes in K fragments, blank ones among them.
  [[gnu::always_inline]] inline void absorb(const fragment* chunk) noexcept;

  /// Writes the `k` first, no_fragment() where there are fewer; returns how many there are.
  [[gnu::always_inline]] inline std::uint32_t write(fragment* nearest, std::uint32_t k) const noexcept;

  /// The depth of the last of K, +inf where there are fewer.
  [[nodiscard]] inline float bound() const noexcept;

  [[nodiscard]] bool is_empty() const noexcept { return !held_; }
  /// True if the keys do not tell all: a -0 or a refused id was among what was absorbed.
  [[nodiscard]] bool is_inexact() const noexcept { return inexact_; }
  void clear() noexcept { held_ = negative_ = inexact_ = false; }

 private:
  using lanes = vector_lanes<Isa>;
  using keys = typename lanes::keys;
  using words = typename lanes::words;
  using longs = typename lanes::longs;
  static constexpr std::uint32_t rows = K / lanes::key_count;

  /// As words, with the depth above the id.
  [[nodiscard, gnu::always_inline]] static inline words both(std::uint32_t depth, std::uint32_t id) noexcept {
    return (words)(longs{} + (std::uint64_t{depth} << 32 | id));
  }

  keys key_[rows] = {};    ///< sorted as lane_network does
  bool held_ = false;      ///< something was absorbed
  bool negative_ = false;  ///< some keys may be those of negative depths
  bool inexact_ = false;
};

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
  using lanes = vector_lanes<Isa>;
  static constexpr std::uint32_t block = 64u;
  static constexpr std::uint32_t burst = 8u;

  /// Bit i is set where fragment base + i of the list is within the bound.
  [[nodiscard, gnu::always_inline]] inline std::uint64_t near_in_block(std::size_t base) const noexcept;
  /// Absorbs what was copied and takes the bound from it.
  inline void tighten() noexcept;

  const fragment* list_;
  std::size_t n_;
  float bound_;
  std::size_t count_;  ///< copied to kept_
  nearest_keys<K, Isa> best_;
  alignas(64) fragment kept_[3u * K + block + burst];
};

inline std::uint64_t key_of(std::uint32_t depth, std::uint32_t id) noexcept {
  const std::uint32_t magnitude = depth & 0x7fffffffu;
  if (magnitude > 0x7f800000u) {
    return std::uint64_t{blank_depth + key_offset} << 32;
  }
  return std::uint64_t{depth + key_offset} << 32 | (depth == magnitude ? id : ~id);
}

inline fragment fragment_of(std::uint64_t key) noexcept {
  const auto depth = static_cast<std::uint32_t>(key >> 32) - key_offset;
  const auto low = static_cast<std::uint32_t>(key);
  return fragment{std::bit_cast<float>(depth), depth <= 0x7fffffffu ? low : ~low};
}

inline fragment blank() noexcept {
  return fragment{std::bit_cast<float>(blank_depth), 0u};
}

template <std::uint32_t K, vector_isa Isa>
inline void nearest_keys<K, Isa>::absorb(const fragment* chunk) noexcept {
  keys key[rows];
  words greatest{};
  unroll<rows>([&](auto r) __attribute__((always_inline)) {
    words word;
    std::memcpy(&word, chunk + r * lanes::key_count, sizeof word);
    word = lanes::template flip<1>(word);
    greatest = lanes::max(greatest, word);
    key[r] = (keys)(word + both(key_offset, 0u));
  });
  if (lanes::any_above(greatest, both(blank_depth, 0xfffffffeu))) [[unlikely]] {  // negative, NaN, a refused id
    std::uint64_t exact[K];
    for (std::uint32_t i = 0u; i < K; ++i) {
      const auto depth = std::bit_cast<std::uint32_t>(chunk[i].depth);
      inexact_ |= depth == 0x80000000u || chunk[i].id == 0xffffffffu;
      exact[i] = key_of(depth, chunk[i].id);
    }
    std::memcpy(key, exact, sizeof exact);
    negative_ = true;
  }
  lane_network::sort<lanes>(key);
  if (held_) {
    lane_network::keep_least<lanes>(key_, key);
  } else {
    unroll<rows>([&](auto r) __attribute__((always_inline)) { key_[r] = key[r]; });
    held_ = true;
  }
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint32_t nearest_keys<K, Isa>::write(fragment* nearest, std::uint32_t k) const noexcept {
  fragment column[K];
  if (!negative_) {
    unroll<rows>([&](auto r) __attribute__((always_inline)) {
      const words word = lanes::template flip<1>((words)key_[r] - both(key_offset, 0u));
      std::memcpy(column + r * lanes::key_count, &word, sizeof word);
    });
  } else {
    std::uint64_t key[K];
    std::memcpy(key, key_, sizeof key);
    for (std::uint32_t i = 0u; i < K; ++i) {
      column[i] = fragment_of(key[i]);
    }
  }
  for (std::uint32_t i = 0u; i < k; ++i) {
    nearest[i] = column[i % rows * lanes::key_count + i / rows];
  }
  std::uint32_t held = k;
  while (held > 0u && std::bit_cast<std::uint32_t>(nearest[held - 1u].depth) == blank_depth) {
    --held;
    nearest[held] = no_fragment();
  }
  return held;
}

template <std::uint32_t K, vector_isa Isa>
inline float nearest_keys<K, Isa>::bound() const noexcept {
  const double last = key_[rows - 1u][lanes::key_count - 1u];
  const float depth = fragment_of(std::bit_cast<std::uint64_t>(last)).depth;
  return std::bit_cast<std::uint32_t>(depth) == blank_depth ? std::numeric_limits<float>::infinity() : depth;
}

template <std::uint32_t K, vector_isa Isa>
inline void long_list<K, Isa>::start(const fragment* list, std::size_t n) noexcept {
  using depths = typename lanes::depths;
  constexpr std::uint32_t rows = 2u * K / lanes::depth_count;
  depths least[rows];
  unroll<rows>([&](auto r) __attribute__((always_inline)) {
    least[r] = depths{} + std::numeric_limits<float>::infinity();
  });
  const auto lower = [&](auto r, std::size_t i) __attribute__((always_inline)) {
    least[r] = lanes::min(lanes::shuffled_depths_of(list + i + r * lanes::depth_count), least[r]);
  };
  std::size_t i = 0u;
  for (; i + 2u * K <= n; i += 2u * K) {
    unroll<rows>([&](auto r) __attribute__((always_inline)) { lower(r, i); });
  }
  // What does not fill a vector at the end is left out: a bound from fewer fragments is still one.
  unroll<rows - 1u>([&](auto r) __attribute__((always_inline)) {
    if (i + (r + 1u) * lanes::depth_count <= n) {
      lower(r, i);
    }
  });
  list_ = list;
  n_ = n;
  bound_ = lane_network::lower_median<lanes>(least);
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
inline std::uint64_t long_list<K, Isa>::near_in_block(std::size_t base) const noexcept {
  const auto limit = typename lanes::depths{} + bound_;
  std::uint64_t near = 0u;
  if (base + block <= n_) {
    unroll<block / lanes::depth_count>([&](auto v) __attribute__((always_inline)) {
      constexpr std::uint32_t first = v * lanes::depth_count;
      near |= std::uint64_t{lanes::within(lanes::depths_of(list_ + base + first), limit)} << first;
    });
  } else {
    // The last vector looks back at fragments already seen; the shift drops their bits.
    for (std::size_t i = base; i < n_; i += lanes::depth_count) {
      const std::size_t first = std::min(i, n_ - lanes::depth_count);
      const std::uint64_t bits = lanes::within(lanes::depths_of(list_ + first), limit);
      near |= bits >> (i - first) << (i - base);
    }
  }
  return near;
}

template <std::uint32_t K, vector_isa Isa>
[[gnu::noinline]] inline void long_list<K, Isa>::tighten() noexcept {
  std::size_t from = 0u;
  for (; from + K <= count_; from += K) {
    best_.absorb(kept_ + from);
  }
  count_ -= from;
  std::copy_n(kept_ + from, count_, kept_);
  bound_ = std::min(bound_, best_.bound());
}

/// The slow way, for a list that has what keys cannot tell.
template <std::uint32_t K>
[[gnu::noinline]] inline std::uint32_t select_in_k_buffer(const fragment* list, std::size_t n, fragment* nearest,
                                                          std::uint32_t k) noexcept {
  auto buffer = k_buffer<K>::empty();
  for (std::size_t i = 0u; i < n; ++i) {
    static_cast<void>(buffer.insert(list[i]));
  }
  buffer.sort();
  std::copy_n(buffer.slot.begin(), k, nearest);
  return std::min(k, buffer.size());
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint32_t long_list<K, Isa>::finish(fragment* nearest, std::uint32_t k) noexcept {
  for (std::size_t from = 0u; from < count_ || best_.is_empty(); from += K) {
    best_.absorb(kept_ + from);
  }
  return best_.is_inexact() ? select_in_k_buffer<K>(list_, n_, nearest, k) : best_.write(nearest, k);
}

/// k_select by the network for K, which is a power of two, of which the `k` first are written.
template <std::uint32_t K, vector_isa Isa>
std::uint32_t select(const fragment* list, std::size_t n, fragment* nearest, std::uint32_t k) noexcept {
  if (n > 2u * K) {
    long_list<K, Isa> one;
    one.start(list, n);
    one.gather();
    return one.finish(nearest, k);
  }
  if constexpr (K > 8u) {
    if (n <= K / 2u) {
      const std::uint32_t half = std::min(k, K / 2u);
      std::fill(nearest + half, nearest + k, no_fragment());
      return select<K / 2u, Isa>(list, n, nearest, half);
    }
  }
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
  return best.is_inexact() ? select_in_k_buffer<K>(list, n, nearest, k) : best.write(nearest, k);
}

/// The network for K.
template <std::uint32_t K>
inline constexpr std::uint32_t network_size = std::max(8u, std::bit_ceil(K));

}  // namespace detail

template <std::uint32_t K, vector_isa Isa>
std::uint32_t k_select(std::span<const fragment> list, std::span<fragment, K> nearest) noexcept {
  static_assert(K >= 1u && K <= 64u, "pelage::k_select<K>: K must be in [1, 64]");
  return detail::select<detail::network_size<K>, Isa>(list.data(), list.size(), nearest.data(), K);
}

template <std::uint32_t K, vector_isa Isa>
void k_select(std::span<const fragment> fragments, std::span<const std::uint32_t> first,
              std::span<fragment> nearest) noexcept {
  static_assert(K >= 1u && K <= 64u, "pelage::k_select<K>: K must be in [1, 64]");
  constexpr std::uint32_t N = detail::network_size<K>;
  constexpr std::size_t together = 4u;
  const std::size_t pixels = first.empty() ? 0u : first.size() - 1u;
  PELAGE_ASSERT(nearest.size() >= pixels * K);
  const auto length = [&](std::size_t p) { return std::size_t{first[p + 1u]} - first[p]; };
  for (std::size_t p = 0u; p < pixels;) {
    std::size_t long_ones = 0u;
    while (long_ones < together && p + long_ones < pixels && length(p + long_ones) > 2u * N) {
      ++long_ones;
    }
    if (long_ones == together) {
      detail::long_list<N, Isa> list[together];
      for (std::size_t i = 0u; i < together; ++i) {
        list[i].start(fragments.data() + first[p + i], length(p + i));
      }
      for (std::size_t i = 0u; i < together; ++i) {
        list[i].gather();
      }
      for (std::size_t i = 0u; i < together; ++i) {
        list[i].finish(nearest.data() + (p + i) * K, K);
      }
      p += together;
    } else {
      detail::select<N, Isa>(fragments.data() + first[p], length(p), nearest.data() + p * K, K);
      ++p;
    }
  }
}

}  // namespace pelage
