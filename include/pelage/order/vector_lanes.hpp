// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <cstdint>
#include <cstring>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace pelage {

/// The instruction sets that k_select is made for. `plain` is any machine: vectors of 16 bytes, of which the compiler
/// makes what it can.
enum class vector_isa : std::uint32_t { plain, sse2, neon, avx2, avx512 };

/// The widest set that this translation unit is compiled for. It is part of the name of every function that depends
/// on it, so units of one program that are compiled with different flags share none.
#if defined(__AVX512F__)
inline constexpr vector_isa widest_isa = vector_isa::avx512;
#elif defined(__AVX2__)
inline constexpr vector_isa widest_isa = vector_isa::avx2;
#elif defined(__SSE2__)
inline constexpr vector_isa widest_isa = vector_isa::sse2;
#elif defined(__aarch64__)
inline constexpr vector_isa widest_isa = vector_isa::neon;
#else
inline constexpr vector_isa widest_isa = vector_isa::plain;
#endif

/// Calls f(i) for i = 0, 1, … N - 1, each a constant: unrolled under any optimisation, so that arrays of vectors
/// stay in registers.
template <std::uint32_t N, class F>
[[gnu::always_inline]] inline void unroll(F f) noexcept;

/// The vector types of a size; elements can be written as v[i].
template <std::uint32_t Bytes>
struct vector_types {
  typedef float depths __attribute__((vector_size(Bytes)));
  typedef double keys __attribute__((vector_size(Bytes)));
  typedef std::uint32_t words __attribute__((vector_size(Bytes)));
  typedef std::uint64_t longs __attribute__((vector_size(Bytes)));
};

/// A vector of depths, a vector of keys (fragments as sortable doubles), and what k_select does with them.
///
/// Written in the vector types of g++ (12 or later) and clang; only what turns a comparison into bits names
/// instructions. Where the caller has set denormals-are-zero, minima and comparisons of depths take every denormal
/// for 0, all in the same way.
template <vector_isa Isa>
struct vector_lanes {
  static constexpr std::uint32_t bytes = Isa == vector_isa::avx512 ? 64u : Isa == vector_isa::avx2 ? 32u : 16u;
  static constexpr std::uint32_t depth_count = bytes / 4u;
  static constexpr std::uint32_t key_count = bytes / 8u;

  using depths = typename vector_types<bytes>::depths;
  using keys = typename vector_types<bytes>::keys;
  using words = typename vector_types<bytes>::words;
  using longs = typename vector_types<bytes>::longs;

  /// The depths of `depth_count` fragments, lane i that of fragment i.
  [[nodiscard, gnu::always_inline]] static inline depths depths_of(const fragment* f) noexcept;

  /// The same depths in another order, which takes one instruction less.
  [[nodiscard, gnu::always_inline]] static inline depths shuffled_depths_of(const fragment* f) noexcept;

  /// Bit i is set where lane i of `depth` is at most that of `bound`, clear where it is NaN.
  [[nodiscard, gnu::always_inline]] static inline std::uint32_t within(depths depth, depths bound) noexcept;

  /// True if a lane of `word` is above that of `limit`, as unsigned numbers.
  [[nodiscard, gnu::always_inline]] static inline bool any_above(words word, words limit) noexcept;

  /// The lesser in each lane, `b` where one of both is NaN: a running minimum in `b` never becomes NaN.
  template <class Vector>
  [[nodiscard, gnu::always_inline]] static inline Vector min(Vector a, Vector b) noexcept {
    return a < b ? a : b;
  }

  /// The greater in each lane, `b` where one of both is NaN.
  template <class Vector>
  [[nodiscard, gnu::always_inline]] static inline Vector max(Vector a, Vector b) noexcept {
    return a > b ? a : b;
  }

  /// Lane i of the result is lane i ^ D of `v`.
  template <std::uint32_t D, class Vector>
  [[nodiscard, gnu::always_inline]] static inline Vector flip(Vector v) noexcept;

  /// Lane i of the result is that of `a` where bit D of i is clear, that of `b` where it is set.
  template <std::uint32_t D, class Vector>
  [[nodiscard, gnu::always_inline]] static inline Vector pick(Vector a, Vector b) noexcept;

  /// Lanes of a vector of depths, keys or words.
  template <class Vector>
  static constexpr std::uint32_t count = bytes / sizeof(Vector{}[0]);

 private:
  [[nodiscard, gnu::always_inline]] static inline std::uint32_t bits_of(words mask) noexcept;
};

// ---------------------------------------------------------------------------------------------------------

template <std::uint32_t N, class F>
inline void unroll(F f) noexcept {
  [&]<std::uint32_t... I>(std::integer_sequence<std::uint32_t, I...>) __attribute__((always_inline)) {
    (f(std::integral_constant<std::uint32_t, I>{}), ...);
  }
  (std::make_integer_sequence<std::uint32_t, N>{});
}

/// A vector made of lanes of `a` and `b`: lane i is number source(i) of both together.
template <auto Source, class Vector, std::uint32_t... I>
[[nodiscard, gnu::always_inline]] inline Vector shuffle(Vector a, Vector b,
                                                        std::integer_sequence<std::uint32_t, I...>) noexcept {
  return __builtin_shufflevector(a, b, static_cast<int>(Source(I))...);
}

template <vector_isa Isa>
auto vector_lanes<Isa>::depths_of(const fragment* f) noexcept -> depths {
  depths low, high;
  std::memcpy(&low, f, bytes);
  std::memcpy(&high, f + key_count, bytes);
  constexpr auto even = [](std::uint32_t i) { return 2u * i; };
  return shuffle<even>(low, high, std::make_integer_sequence<std::uint32_t, depth_count>{});
}

template <vector_isa Isa>
auto vector_lanes<Isa>::shuffled_depths_of(const fragment* f) noexcept -> depths {
  depths low, high;
  std::memcpy(&low, f, bytes);
  std::memcpy(&high, f + key_count, bytes);
  constexpr auto even_in_block = [](std::uint32_t i) {
    return i / 4u * 4u + 2u * (i % 2u) + (i % 4u < 2u ? 0u : depth_count);
  };
  return shuffle<even_in_block>(low, high, std::make_integer_sequence<std::uint32_t, depth_count>{});
}

template <vector_isa Isa>
std::uint32_t vector_lanes<Isa>::within(depths depth, depths bound) noexcept {
#if defined(__AVX512F__)
  if constexpr (Isa == vector_isa::avx512) {
    return _mm512_cmp_ps_mask(depth, bound, _CMP_LE_OQ);
  }
#endif
  return bits_of((words)(depth <= bound));
}

template <vector_isa Isa>
bool vector_lanes<Isa>::any_above(words word, words limit) noexcept {
#if defined(__AVX512F__)
  if constexpr (Isa == vector_isa::avx512) {
    return _mm512_cmpgt_epu32_mask((__m512i)word, (__m512i)limit) != 0;
  }
#endif
  return bits_of((words)(word > limit)) != 0u;
}

template <vector_isa Isa>
std::uint32_t vector_lanes<Isa>::bits_of(words mask) noexcept {
#if defined(__AVX2__)
  if constexpr (Isa == vector_isa::avx2) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)mask));
  }
#endif
#if defined(__SSE2__)
  if constexpr (Isa == vector_isa::sse2) {
    return static_cast<std::uint32_t>(_mm_movemask_ps((__m128)mask));
  }
#elif defined(__aarch64__)
  if constexpr (Isa == vector_isa::neon) {
    return vaddvq_u32((uint32x4_t)(mask & words{1u, 2u, 4u, 8u}));
  }
#endif
  std::uint32_t bits = 0u;
  for (std::uint32_t i = 0u; i < depth_count; ++i) {
    bits |= mask[i] & (1u << i);
  }
  return bits;
}

template <vector_isa Isa>
template <std::uint32_t D, class Vector>
Vector vector_lanes<Isa>::flip(Vector v) noexcept {
  constexpr auto other = [](std::uint32_t i) { return i ^ D; };
  return shuffle<other>(v, v, std::make_integer_sequence<std::uint32_t, count<Vector>>{});
}

template <vector_isa Isa>
template <std::uint32_t D, class Vector>
Vector vector_lanes<Isa>::pick(Vector a, Vector b) noexcept {
  constexpr auto side = [](std::uint32_t i) { return (i & D) == 0u ? i : i + count<Vector>; };
  return shuffle<side>(a, b, std::make_integer_sequence<std::uint32_t, count<Vector>>{});
}

}  // namespace pelage
