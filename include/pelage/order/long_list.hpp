// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
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

/// How k_select goes through a long list. Not for use by itself.
namespace pelage::inline PELAGE_ABI::detail {

/// One list of more than 2 K fragments on its way: start(), gather(), finish().
template <std::uint32_t K, vector_isa Isa>
class long_list {
 public:
  /// Finds the bound of the `k` nearest.
  [[gnu::always_inline]] inline void start(const fragment* list, std::size_t n, std::uint32_t k) noexcept;
  /// Copies what is within it.
  [[gnu::always_inline]] inline void gather() noexcept;
  /// Sorts that.
  [[gnu::always_inline]] inline std::uint32_t finish(fragment* nearest, std::uint32_t k) noexcept;

 private:
  static constexpr std::uint32_t width = lane_width(Isa);
  using depths = lanes<width>;
  static constexpr std::uint32_t block = 64u;
  static constexpr std::uint32_t burst = 8u;
  /// Of how many blocks the least depths are kept, so that gather() reads those alone that have some within the bound.
  /// With a larger K almost every block has.
  static constexpr std::size_t summaries = K <= 8u ? 32u : 0u;

  /// The depths of `width` fragments, Source(i) the number of lane i's in two vectors of depths and ids.
  template <auto Source>
  [[nodiscard, gnu::always_inline]] static inline depths depths_of(const fragment* f) noexcept {
    depths low, high;
    std::memcpy(&low.lane, f, sizeof low.lane);
    std::memcpy(&high.lane, f + width / 2u, sizeof high.lane);
    return shuffled<Source>(low, high);
  }
  /// Bit i is set where a depth is at most the bound, clear where it is NaN. Where the caller has set
  /// denormals-are-zero, every denormal counts as 0, here and in the bound.
  [[nodiscard, gnu::always_inline]] static inline std::uint32_t within(depths depth, depths bound) noexcept;
  /// Bit i is set where fragment base + i of the list is within the bound.
  [[nodiscard, gnu::always_inline]] inline std::uint64_t near_in_block(std::size_t base) const noexcept;
  /// Copies what is within the bound of a block.
  [[gnu::always_inline]] inline void take_block(std::size_t base) noexcept;
  /// Absorbs what was copied and takes the bound from it.
  [[gnu::noinline]] void tighten() noexcept;

  const fragment* list_;
  std::size_t n_;
  float bound_;
  std::size_t summarised_;  ///< blocks in least_
  std::size_t count_;       ///< copied to kept_
  nearest_keys<K, Isa> best_;
  depths least_[std::max<std::size_t>(summaries, 1u)];  ///< of each block, by lane
  alignas(64) fragment kept_[3u * K + block + burst];
};

/// The K nearest by insertion, for a list that has what keys cannot tell. Compares integers, not floats: exact with
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

// ---------------------------------------------------------------------------------------------------------

template <std::uint32_t K, vector_isa Isa>
inline void long_list<K, Isa>::start(const fragment* list, std::size_t n, std::uint32_t k) noexcept {
  constexpr std::uint32_t rows = 2u * K / width;
  // Not in order, which takes one instruction less.
  constexpr auto source = [](int i) { return i / 4 * 4 + 2 * (i % 2) + (i % 4 < 2 ? 0 : int{width}); };
  depths nearest[rows];
  const depths none(std::numeric_limits<float>::infinity());
  unroll<rows>([&](auto r) __attribute__((always_inline)) { nearest[r] = none; });
  const auto lower = [&](depths & to, auto r, std::size_t i) __attribute__((always_inline)) {
    to = least(depths_of<source>(list + i + r * width), to);  // of a NaN, the second
  };
  summarised_ = n < 4u * block ? 0u : std::min(n / block, summaries);
  std::size_t i = 0u;
  if constexpr (summaries > 0u) {
    for (; i < summarised_ * block; i += block) {
      depths in_block = none;
      unroll<rows>([&](auto r) __attribute__((always_inline)) {
        depths in_row = none;
        unroll<block / (2u * K)>([&](auto j) __attribute__((always_inline)) { lower(in_row, r, i + j * 2u * K); });
        nearest[r] = least(nearest[r], in_row);
        in_block = least(in_block, in_row);
      });
      least_[i / block] = in_block;
    }
  }
  for (; i + 2u * K <= n; i += 2u * K) {
    unroll<rows>([&](auto r) __attribute__((always_inline)) { lower(nearest[r], r, i); });
  }
  // What does not fill a vector at the end is left out: a bound from fewer fragments is still one.
  unroll<rows - 1u>([&](auto r) __attribute__((always_inline)) {
    if (i + (r + 1u) * width <= n) {
      lower(nearest[r], r, i);
    }
  });
  if (2u * k <= K) {  // half as many columns do, each of which counts twice here
    unroll<rows>([&](auto r) __attribute__((always_inline)) {
      nearest[r] = least(nearest[r], flipped<int{width} / 2>(nearest[r]));
    });
  }
  list_ = list;
  n_ = n;
  bound_ = lane_network::lower_median(nearest);
  count_ = 0u;
  best_.clear();
}

template <std::uint32_t K, vector_isa Isa>
inline void long_list<K, Isa>::gather() noexcept {
  if constexpr (summaries > 0u) {
    const depths limit(bound_);
    std::uint32_t near = 0u;
    for (std::uint32_t b = 0u; b < summarised_; ++b) {
      near |= std::uint32_t{within(least_[b], limit) != 0u} << b;
    }
    for (; near != 0u; near &= near - 1u) {
      take_block(static_cast<std::size_t>(std::countr_zero(near)) * block);
    }
  }
  for (std::size_t base = summarised_ * block; base < n_; base += block) {
    take_block(base);
  }
  std::fill_n(kept_ + count_, K, blank());
}

template <std::uint32_t K, vector_isa Isa>
inline void long_list<K, Isa>::take_block(std::size_t base) noexcept {
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

template <std::uint32_t K, vector_isa Isa>
inline std::uint32_t long_list<K, Isa>::within(depths depth, depths bound) noexcept {
#if defined(__AVX512F__)
  if constexpr (Isa == vector_isa::avx512) {  // bits() takes two instructions more
    return _mm512_cmp_ps_mask(__m512(depth.lane), __m512(bound.lane), _CMP_LE_OQ);
  }
#endif
  return bits(depth <= bound);
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint64_t long_list<K, Isa>::near_in_block(std::size_t base) const noexcept {
  constexpr auto even = [](int i) { return 2 * i; };
  const depths limit(bound_);
  std::uint64_t near = 0u;
  if (base + block <= n_) {
    unroll<block / width>([&](auto v) __attribute__((always_inline)) {
      constexpr std::uint32_t first = v * width;
      near |= std::uint64_t{within(depths_of<even>(list_ + base + first), limit)} << first;
    });
  } else {
    // The last vector looks back at fragments already seen; the shift drops their bits.
    for (std::size_t i = base; i < n_; i += width) {
      const std::size_t first = std::min(i, n_ - width);
      near |= std::uint64_t{within(depths_of<even>(list_ + first), limit)} >> (i - first) << (i - base);
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

template <std::uint32_t K, vector_isa Isa>
inline std::uint32_t long_list<K, Isa>::finish(fragment* nearest, std::uint32_t k) noexcept {
  for (std::size_t from = 0u; from < count_ || best_.is_empty(); from += K) {
    best_.absorb(kept_ + from);
  }
  return best_.is_inexact() ? select_by_insertion(list_, n_, nearest, k) : best_.write(nearest, k);
}

}  // namespace pelage::detail
