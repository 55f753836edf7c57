// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>
#include <pelage/core/lane_moves.hpp>
#include <pelage/core/lanes.hpp>
#include <pelage/order/lane_network.hpp>

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

/// What k_select sorts by. Not for use by itself.
namespace pelage::inline PELAGE_ABI::detail {

static_assert(std::endian::native == std::endian::little, "pelage: k_select takes a fragment's depth for its low word");

/// The bits of the depth that stands in a list for no fragment: a NaN, next after +inf.
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
[[nodiscard]] inline fragment blank() noexcept {
  return fragment{std::bit_cast<float>(blank_depth), 0u};
}

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
  static constexpr std::uint32_t key_count = lane_width(Isa) / 2u;
  static constexpr std::uint32_t rows = K / key_count;
  using keys = lanes<key_count, double>;
  using words = lanes<lane_width(Isa), std::uint32_t>;

  /// As words, with the depth above the id.
  [[nodiscard, gnu::always_inline]] static inline words both(std::uint32_t depth, std::uint32_t id) noexcept {
    return bits_as<words>(lanes<key_count, std::uint64_t>(std::uint64_t{depth} << 32 | id));
  }

  /// True if a lane of `word` is above that of `limit`.
  [[nodiscard, gnu::always_inline]] static inline bool any_above(words word, words limit) noexcept {
#if defined(__AVX512F__)
    if constexpr (Isa == vector_isa::avx512) {  // holds_for_any() takes two instructions more
      return _mm512_cmpgt_epu32_mask(__m512i(word.lane), __m512i(limit.lane)) != 0;
    }
#endif
    return holds_for_any(word > limit);
  }

  keys key_[rows] = {};    ///< sorted as lane_network does
  bool held_ = false;      ///< something was absorbed
  bool negative_ = false;  ///< some keys may be those of negative depths
  bool inexact_ = false;
};

// ---------------------------------------------------------------------------------------------------------

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

template <std::uint32_t K, vector_isa Isa>
inline void nearest_keys<K, Isa>::absorb(const fragment* chunk) noexcept {
  keys key[rows];
  words most(0u);
  unroll<rows>([&](auto r) __attribute__((always_inline)) {
    words word;
    std::memcpy(&word.lane, chunk + r * key_count, sizeof word.lane);
    word = flipped<1>(word);
    most = select(most > word, most, word);
    key[r] = bits_as<keys>(word + both(key_offset, 0u));
  });
  if (any_above(most, both(blank_depth, 0xfffffffeu))) [[unlikely]] {  // negative, NaN, a refused id
    std::uint64_t exact[K];
    for (std::uint32_t i = 0u; i < K; ++i) {
      const auto depth = std::bit_cast<std::uint32_t>(chunk[i].depth);
      inexact_ |= depth == 0x80000000u || chunk[i].id == 0xffffffffu;
      exact[i] = key_of(depth, chunk[i].id);
    }
    std::memcpy(key, exact, sizeof exact);
    negative_ = true;
  }
  lane_network::sort(key);
  if (held_) {
    lane_network::keep_least(key_, key);
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
      const words word = flipped<1>(bits_as<words>(key_[r]) - both(key_offset, 0u));
      std::memcpy(column + r * key_count, &word.lane, sizeof word.lane);
    });
  } else {
    std::uint64_t key[K];
    std::memcpy(key, key_, sizeof key);
    for (std::uint32_t i = 0u; i < K; ++i) {
      column[i] = fragment_of(key[i]);
    }
  }
  for (std::uint32_t i = 0u; i < k; ++i) {
    nearest[i] = column[i % rows * key_count + i / rows];
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
  const double last = key_[rows - 1u].lane[key_count - 1u];
  const float depth = fragment_of(std::bit_cast<std::uint64_t>(last)).depth;
  return std::bit_cast<std::uint32_t>(depth) == blank_depth ? std::numeric_limits<float>::infinity() : depth;
}

}  // namespace pelage::detail
