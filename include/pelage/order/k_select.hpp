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
/// O(n) with few operations a fragment when the near ones are spread over the list, which is what most lists are;
/// O(n log² K) at worst. No allocation; less than 32 K + 2048 bytes of stack. Lists with a -0 or with a refused id
/// among the near are done by k_buffer, O(n K).
template <std::uint32_t K, vector_isa Isa = widest_isa>
std::uint32_t k_select(std::span<const fragment> list, std::span<fragment, K> nearest) noexcept;

/// k_select for every pixel of a resolved A-buffer. The fragments of pixel p are those from first[p] up to
/// first[p + 1]; its nearest go to nearest[p K] and on.
///
/// `first`: one more than there are pixels, ascending, none beyond the fragments. `nearest`: K a pixel.
template <std::uint32_t K, vector_isa Isa = widest_isa>
void k_select(std::span<const fragment> fragments, std::span<const std::uint32_t> first,
              std::span<fragment> nearest) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// The key of a fragment that is refused, or of none: behind every other.
inline constexpr std::uint64_t no_key = 0x7f90000100000000u;
/// Added to the depth's bits, so that every key is a normal double: nothing is flushed to zero.
inline constexpr std::uint32_t key_offset = 0x00100000u;
/// The bits of no_key's depth, a NaN that no other use is made of.
inline constexpr std::uint32_t no_key_depth = 0x7f800001u;

/// The K least keys so far, sorted. K: a power of two from 8 on.
template <std::uint32_t K, vector_isa Isa>
class nearest_keys {
 public:
  static constexpr std::uint32_t capacity = 2u * K;

  /// Takes in K fragments; a place that holds none has the bits `no_key_depth` for a depth.
  [[gnu::always_inline]] inline void absorb(const fragment* chunk) noexcept;

  [[nodiscard]] float bound() const noexcept;
  [[gnu::always_inline]] inline std::uint32_t write(fragment* nearest, std::uint32_t k) const noexcept;
  [[nodiscard]] bool needs_k_buffer() const noexcept { return odd_; }
  [[nodiscard]] bool held() const noexcept { return held_; }
  void clear() noexcept { held_ = signed_ = odd_ = false; }

 private:
  using lanes = vector_lanes<Isa>;
  using keys = typename lanes::keys;
  using words = typename lanes::words;
  using longs = typename lanes::longs;
  static constexpr std::uint32_t rows = K / lanes::key_count;

  keys key_[rows] = {};  
  bool held_ = false;    ///< key_ holds keys
  bool signed_ = false;  ///< some of them negative depths
  bool odd_ = false;     ///< a -0 or a refused id was seen
};

[[nodiscard]] inline fragment blank() noexcept { return fragment{std::bit_cast<float>(no_key_depth), 0u}; }

[[nodiscard]] inline std::uint64_t key_of(std::uint32_t depth, std::uint32_t id) noexcept {
  const std::uint32_t magnitude = depth & 0x7fffffffu;
  if (magnitude > 0x7f800000u) {
    return no_key;
  }
  const std::uint32_t low = depth == magnitude ? id : ~id;
  return std::uint64_t{depth + key_offset} << 32 | low;
}

[[nodiscard]] inline fragment fragment_of(std::uint64_t key) noexcept {
  const auto depth = static_cast<std::uint32_t>(key >> 32) - key_offset;
  const auto low = static_cast<std::uint32_t>(key);
  return fragment{std::bit_cast<float>(depth), depth <= 0x7fffffffu ? low : ~low};
}

template <std::uint32_t K, vector_isa Isa>
inline void nearest_keys<K, Isa>::absorb(const fragment* chunk) noexcept {
  // As 32-bit words a key is id, then depth.
  const auto limit = (words)(longs{} + (std::uint64_t{no_key_depth} << 32 | 0xfffffffeu));
  const auto offset = (words)(longs{} + (std::uint64_t{key_offset} << 32));
  words greatest{};
  keys key[rows];
  unroll<rows>([&](auto r) __attribute__((always_inline)) {
    words raw;
    std::memcpy(&raw, chunk + r * lanes::key_count, sizeof raw);
    raw = lanes::template flip<1>(raw);
    greatest = lanes::max(greatest, raw);
    key[r] = (keys)(raw + offset);
  });
  if (lanes::any_above(greatest, limit)) [[unlikely]] {
    std::uint64_t slow[K];
    for (std::uint32_t i = 0u; i < K; ++i) {
      const auto depth = std::bit_cast<std::uint32_t>(chunk[i].depth);
      odd_ |= depth == 0x80000000u || chunk[i].id == 0xffffffffu;
      slow[i] = key_of(depth, chunk[i].id);
    }
    std::memcpy(key, slow, sizeof slow);
    signed_ = true;
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
float nearest_keys<K, Isa>::bound() const noexcept {
  const double last = key_[rows - 1u][lanes::key_count - 1u];
  const auto key = std::bit_cast<std::uint64_t>(last);
  return key == no_key ? std::numeric_limits<float>::infinity() : fragment_of(key).depth;
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint32_t nearest_keys<K, Isa>::write(fragment* nearest, std::uint32_t k) const noexcept {
  std::uint64_t key[K];
  std::memcpy(key, key_, sizeof key);
  if (!signed_) {
    const auto offset = (words)(longs{} + (std::uint64_t{key_offset} << 32));
    fragment column[K];
    unroll<rows>([&](auto r) __attribute__((always_inline)) {
      const words raw = lanes::template flip<1>((words)key_[r] - offset);
      std::memcpy(column + r * lanes::key_count, &raw, sizeof raw);
    });
    for (std::uint32_t e = 0u; e < k; ++e) {
      nearest[e] = column[e % rows * lanes::key_count + e / rows];
    }
  } else {
    for (std::uint32_t e = 0u; e < k; ++e) {
      nearest[e] = fragment_of(key[e % rows * lanes::key_count + e / rows]);
    }
  }
  std::uint32_t held = k;
  while (held > 0u && std::bit_cast<std::uint32_t>(nearest[held - 1u].depth) == no_key_depth) {
    --held;
    nearest[held] = no_fragment();
  }
  return held;
}

template <std::uint32_t K, vector_isa Isa>
class pixel {
 public:
  [[gnu::always_inline]] inline void start(const fragment* list, std::size_t n) noexcept;
  [[gnu::always_inline]] inline void gather() noexcept;
  [[gnu::always_inline]] inline std::uint32_t finish(fragment* nearest, std::uint32_t k) noexcept;

 private:
  using lanes = vector_lanes<Isa>;
  static constexpr std::uint32_t burst = 8u;

  [[gnu::always_inline]] inline std::uint64_t near_in_block(std::size_t base) const noexcept;
  void tighten() noexcept;
  std::uint32_t select_in_k_buffer(fragment* nearest, std::uint32_t k) const noexcept;

  const fragment* list_;
  std::size_t n_;
  float bound_;
  std::size_t count_;
  nearest_keys<K, Isa> best_;
  alignas(64) fragment kept_[3u * K + 64u + burst];
};

/// A depth that at least K of the list's depths are within: the K-th least of 2 K minima, each over other fragments.
template <std::uint32_t K, vector_isa Isa>
[[nodiscard, gnu::always_inline]] inline float bound_of(const fragment* list, std::size_t n) noexcept {
  using lanes = vector_lanes<Isa>;
  constexpr std::uint32_t rows = 2u * K / lanes::depth_count;
  typename lanes::depths least[rows];
  unroll<rows>([&](auto r) __attribute__((always_inline)) {
    least[r] = typename lanes::depths{} + std::numeric_limits<float>::infinity();
  });
  std::size_t i = 0u;
  for (; i + 2u * K <= n; i += 2u * K) {
    unroll<rows>([&](auto r) __attribute__((always_inline)) {
      least[r] = lanes::min(lanes::shuffled_depths_of(list + i + r * lanes::depth_count), least[r]);
    });
  }
  // The last few, fewer than a vector, are left out: a looser bound is still one.
  unroll<rows - 1u>([&](auto r) __attribute__((always_inline)) {
    if (i + (r + 1u) * lanes::depth_count <= n) {
      least[r] = lanes::min(lanes::shuffled_depths_of(list + i + r * lanes::depth_count), least[r]);
    }
  });
  return lane_network::lower_median<lanes>(least);
}

template <std::uint32_t K, vector_isa Isa>
inline void pixel<K, Isa>::start(const fragment* list, std::size_t n) noexcept {
  list_ = list;
  n_ = n;
  count_ = 0u;
  best_.clear();
  bound_ = n > 2u * K ? bound_of<K, Isa>(list, n) : std::numeric_limits<float>::infinity();
}

template <std::uint32_t K, vector_isa Isa>
inline void pixel<K, Isa>::gather() noexcept {
  if (n_ <= 2u * K) {
    count_ = n_ % K;
    std::copy_n(list_ + (n_ - count_), count_, kept_);
  } else {
    for (std::size_t base = 0u; base < n_; base += 64u) {
      std::uint64_t near = near_in_block(base);
      fragment* to = kept_ + count_;
      count_ += static_cast<std::size_t>(std::popcount(near));
      while (near != 0u) {
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
  }
  std::fill_n(kept_ + count_, K, blank());
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint64_t pixel<K, Isa>::near_in_block(std::size_t base) const noexcept {
  const auto limit = typename lanes::depths{} + bound_;
  std::uint64_t near = 0u;
  if (base + 64u <= n_) {
    unroll<64u / lanes::depth_count>([&](auto v) __attribute__((always_inline)) {
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
[[gnu::noinline]] void pixel<K, Isa>::tighten() noexcept {
  std::size_t from = 0u;
  for (; from + K <= count_; from += K) {
    best_.absorb(kept_ + from);
  }
  count_ -= from;
  std::copy_n(kept_ + from, count_, kept_);
  bound_ = std::min(bound_, best_.bound());
}

template <std::uint32_t K, vector_isa Isa>
inline std::uint32_t pixel<K, Isa>::finish(fragment* nearest, std::uint32_t k) noexcept {
  if (n_ <= 2u * K) {
    for (std::size_t from = 0u; from + K <= n_; from += K) {
      best_.absorb(list_ + from);
    }
  }
  for (std::size_t from = 0u; from < count_ || !best_.held(); from += K) {
    best_.absorb(kept_ + from);
  }
  if (best_.needs_k_buffer()) [[unlikely]] {
    return select_in_k_buffer(nearest, k);
  }
  return best_.write(nearest, k);
}

template <std::uint32_t K, vector_isa Isa>
[[gnu::noinline]] std::uint32_t pixel<K, Isa>::select_in_k_buffer(fragment* nearest, std::uint32_t k) const noexcept {
  auto buffer = k_buffer<K>::empty();
  for (std::size_t i = 0u; i < n_; ++i) {
    static_cast<void>(buffer.insert(list_[i]));
  }
  buffer.sort();
  std::copy_n(buffer.slot.begin(), k, nearest);
  return std::min(k, buffer.size());
}

template <std::uint32_t K, vector_isa Isa>
std::uint32_t select(const fragment* list, std::size_t n, fragment* nearest, std::uint32_t k) noexcept {
  if constexpr (K > 8u) {
    if (n <= K / 2u) {
      const std::uint32_t near = std::min(k, K / 2u);
      std::fill(nearest + near, nearest + k, no_fragment());
      return select<K / 2u, Isa>(list, n, nearest, near);
    }
  }
  pixel<K, Isa> one;
  one.start(list, n);
  one.gather();
  return one.finish(nearest, k);
}

}  // namespace detail

template <std::uint32_t K, vector_isa Isa>
std::uint32_t k_select(std::span<const fragment> list, std::span<fragment, K> nearest) noexcept {
  static_assert(K >= 1u && K <= 64u, "pelage::k_select<K>: K must be in [1, 64]");
  return detail::select<std::max(8u, std::bit_ceil(K)), Isa>(list.data(), list.size(), nearest.data(), K);
}

template <std::uint32_t K, vector_isa Isa>
void k_select(std::span<const fragment> fragments, std::span<const std::uint32_t> first,
              std::span<fragment> nearest) noexcept {
  PELAGE_ASSERT(first.empty() || nearest.size() >= (first.size() - 1u) * K);
  constexpr std::uint32_t group = GROUP;
  constexpr std::uint32_t W = std::max(8u, std::bit_ceil(K));
  const std::size_t pixels = first.empty() ? 0u : first.size() - 1u;
  std::size_t p = 0u;
  detail::pixel<W, Isa> some[group];
  for (; p + group <= pixels; p += group) {
    for (std::uint32_t g = 0u; g < group; ++g) {
      some[g].start(fragments.data() + first[p + g], first[p + g + 1u] - first[p + g]);
    }
    for (std::uint32_t g = 0u; g < group; ++g) {
      some[g].gather();
    }
    for (std::uint32_t g = 0u; g < group; ++g) {
      some[g].finish(nearest.data() + (p + g) * K, K);
    }
  }
  for (; p < pixels; ++p) {
    static_cast<void>(k_select<K, Isa>(fragments.subspan(first[p], first[p + 1u] - first[p]),
                                       std::span<fragment, K>(nearest.data() + p * K, K)));
  }
}

}  // namespace pelage
