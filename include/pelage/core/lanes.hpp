// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/real_number.hpp>

#include <cmath>
#include <cstdint>
#include <type_traits>

#if defined(__SSE__)
#include <immintrin.h>
#endif

namespace pelage {

/// The compiler's own vectors, by their number of lanes. (GCC 12 does not accept a width that depends on a template.)
template <int W>
struct lane_vectors;
template <>
struct lane_vectors<4> {
  typedef float real __attribute__((vector_size(16)));
  typedef int integer __attribute__((vector_size(16)));
  typedef std::uint32_t natural __attribute__((vector_size(16)));
};
template <>
struct lane_vectors<8> {
  typedef float real __attribute__((vector_size(32)));
  typedef int integer __attribute__((vector_size(32)));
  typedef std::uint32_t natural __attribute__((vector_size(32)));
};
template <>
struct lane_vectors<16> {
  typedef float real __attribute__((vector_size(64)));
  typedef int integer __attribute__((vector_size(64)));
  typedef std::uint32_t natural __attribute__((vector_size(64)));
};

/// W floats that go through a formula together. For the CPU alone; GCC's and clang's vector types underneath, so that
/// it needs no flags and takes what the flags allow. Every operation is the scalar one on each lane, bit for bit.
/// W in {4, 8, 16}; lane_width() is the widest that one instruction handles. sizeof is 4 W, as is the alignment.
template <int W>
struct lanes {
  using vector = typename lane_vectors<W>::real;
  using integers = typename lane_vectors<W>::integer;
  using naturals = typename lane_vectors<W>::natural;

  vector lane;

  lanes() = default;
  explicit lanes(vector all) noexcept : lane(all) {}
  template <class Number>
  requires std::is_arithmetic_v<Number>
  explicit lanes(Number same) noexcept : lane(static_cast<float>(same) - vector{}) {}

  /// W floats from memory of any alignment, and back.
  [[nodiscard]] static lanes load(const float* from) noexcept;
  void store(float* to) const noexcept;
};

/// Which lanes a comparison holds for.
template <int W>
struct lane_mask {
  typename lanes<W>::integers lane;
};

template <int W>
struct is_packed<lanes<W>> : std::true_type {};

/// A mask as a number: bit k is set where the comparison holds for lane k.
template <int W>
[[nodiscard, gnu::always_inline]] inline std::uint32_t bits(lane_mask<W> mask) noexcept;

/// The same number where it holds for all.
template <int W>
[[nodiscard]] constexpr std::uint32_t all_bits() noexcept {
  return (1u << W) - 1u;
}

/// The widest vector of this build, in floats.
[[nodiscard]] constexpr int lane_width() noexcept;

template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> operator+(lanes<W> a, lanes<W> b) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> operator-(lanes<W> a, lanes<W> b) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> operator*(lanes<W> a, lanes<W> b) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> operator/(lanes<W> a, lanes<W> b) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lane_mask<W> operator<(lanes<W> a, lanes<W> b) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lane_mask<W> operator>(lanes<W> a, lanes<W> b) noexcept;

/// The functions of core/real_number.hpp and core/elementary.hpp that a packed type brings along.
template <int W>
[[nodiscard, gnu::always_inline]] inline bool holds_for_any(lane_mask<W> condition) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline bool holds_for_all(lane_mask<W> condition) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> select(lane_mask<W> condition, lanes<W> a, lanes<W> b) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> square_root(lanes<W> x) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> whole_part(lanes<W> x) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline exponent_parts<lanes<W>> split_exponent(lanes<W> biased) noexcept;

// ---------------------------------------------------------------------------------------------------------

constexpr int lane_width() noexcept {
#if defined(__AVX512F__)
  return 16;
#elif defined(__AVX2__)
  return 8;
#else
  return 4;
#endif
}

template <int W>
lanes<W> lanes<W>::load(const float* from) noexcept {
  lanes all;
  __builtin_memcpy(&all.lane, from, sizeof(all.lane));
  return all;
}

template <int W>
void lanes<W>::store(float* to) const noexcept {
  __builtin_memcpy(to, &lane, sizeof(lane));
}

template <int W>
lanes<W> operator+(lanes<W> a, lanes<W> b) noexcept {
  return lanes<W>(a.lane + b.lane);
}

template <int W>
lanes<W> operator-(lanes<W> a, lanes<W> b) noexcept {
  return lanes<W>(a.lane - b.lane);
}

template <int W>
lanes<W> operator*(lanes<W> a, lanes<W> b) noexcept {
  return lanes<W>(a.lane * b.lane);
}

template <int W>
lanes<W> operator/(lanes<W> a, lanes<W> b) noexcept {
  return lanes<W>(a.lane / b.lane);
}

template <int W>
lane_mask<W> operator<(lanes<W> a, lanes<W> b) noexcept {
  return lane_mask<W>{a.lane < b.lane};
}

template <int W>
lane_mask<W> operator>(lanes<W> a, lanes<W> b) noexcept {
  return lane_mask<W>{a.lane > b.lane};
}

template <int W>
std::uint32_t bits(lane_mask<W> mask) noexcept {
#if defined(__AVX512F__)
  if constexpr (W == 16) {
    return static_cast<std::uint32_t>(_mm512_cmplt_epi32_mask(__m512i(mask.lane), __m512i{}));
  }
#endif
#if defined(__AVX__)
  if constexpr (W == 8) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(__m256(mask.lane)));
  }
#endif
#if defined(__SSE__)
  if constexpr (W == 4) {
    return static_cast<std::uint32_t>(_mm_movemask_ps(__m128(mask.lane)));
  }
#endif
  std::uint32_t set = 0u;
  for (int k = 0; k < W; ++k) {
    set |= mask.lane[k] != 0 ? 1u << k : 0u;
  }
  return set;
}

template <int W>
bool holds_for_any(lane_mask<W> condition) noexcept {
  return bits(condition) != 0u;
}

template <int W>
bool holds_for_all(lane_mask<W> condition) noexcept {
  return bits(condition) == all_bits<W>();
}

template <int W>
lanes<W> select(lane_mask<W> condition, lanes<W> a, lanes<W> b) noexcept {
  return lanes<W>(condition.lane ? a.lane : b.lane);
}

template <int W>
lanes<W> square_root(lanes<W> x) noexcept {
#if defined(__AVX512F__)
  if constexpr (W == 16) {
    return lanes<W>(typename lanes<W>::vector(_mm512_maskz_sqrt_ps(0xffff, __m512(x.lane))));
  }
#endif
#if defined(__AVX__)
  if constexpr (W == 8) {
    return lanes<W>(typename lanes<W>::vector(_mm256_sqrt_ps(__m256(x.lane))));
  }
#endif
#if defined(__SSE__)
  if constexpr (W == 4) {
    return lanes<W>(typename lanes<W>::vector(_mm_sqrt_ps(__m128(x.lane))));
  }
#endif
  lanes<W> roots = x;
  for (int k = 0; k < W; ++k) {
    roots.lane[k] = std::sqrt(x.lane[k]);
  }
  return roots;
}

template <int W>
lanes<W> whole_part(lanes<W> x) noexcept {
  using integers = typename lanes<W>::integers;
  using vector = typename lanes<W>::vector;
  return lanes<W>(__builtin_convertvector(__builtin_convertvector(x.lane, integers), vector));
}

template <int W>
exponent_parts<lanes<W>> split_exponent(lanes<W> biased) noexcept {
  using integers = typename lanes<W>::integers;
  using vector = typename lanes<W>::vector;
  const integers e = __builtin_convertvector(biased.lane, integers);
  return exponent_parts<lanes<W>>{lanes<W>(__builtin_convertvector(e, vector)),
                                  lanes<W>(reinterpret_cast<vector>(e << 23))};
}

}  // namespace pelage
