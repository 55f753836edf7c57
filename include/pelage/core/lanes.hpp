// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/real_number.hpp>

#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace pelage::inline PELAGE_ABI {

/// Sets of vector instructions. `plain` is any machine: vectors of 16 bytes, of which the compiler makes what it can.
enum class vector_isa : std::uint32_t { plain, sse2, neon, avx2, avx512 };

/// The widest set that this translation unit is compiled for; PELAGE_ABI (version.hpp) depends on it, too.
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

namespace detail {

/// Calls f(i) for i = 0, 1, … N - 1, each a constant: unrolled under any optimisation, so that arrays of vectors stay
/// in registers.
template <std::uint32_t N, class F>
[[gnu::always_inline]] inline void unroll(F f) noexcept {
  [&]<std::uint32_t... I>(std::integer_sequence<std::uint32_t, I...>) __attribute__((always_inline)) {
    (f(std::integral_constant<std::uint32_t, I>{}), ...);
  }
  (std::make_integer_sequence<std::uint32_t, N>{});
}

}  // namespace detail

/// How many floats one instruction handles.
[[nodiscard]] constexpr int lane_width(vector_isa isa = widest_isa) noexcept {
  return isa == vector_isa::avx512 ? 16 : isa == vector_isa::avx2 ? 8 : 4;
}

/// Which lanes a comparison holds for: all bits of a word are set, or none. Word: as wide as what was compared.
template <int W, class Word = int>
struct lane_mask {
  typedef Word vector __attribute__((vector_size(W * sizeof(Word))));

  vector lane;
};

/// W numbers that go through a formula together. For the CPU alone; GCC's and clang's vector types underneath, so that
/// it needs no flags and takes what the flags allow. Every operation is the scalar one on each lane, bit for bit;
/// integers wrap. W numbers of 4 bytes, W in {4, 8, 16}, or half as many of 8; lane_width() is the widest that one
/// instruction handles. sizeof is that of the numbers, as is the alignment.
template <int W, class T = float>
struct lanes {
  typedef T vector __attribute__((vector_size(W * sizeof(T))));
  using integers = typename lanes<W, int>::vector;
  using naturals = typename lanes<W, std::uint32_t>::vector;
  using mask = lane_mask<W, std::conditional_t<sizeof(T) == 4, int, std::int64_t>>;

  vector lane;

  lanes() = default;
  [[gnu::always_inline]] explicit lanes(vector all) noexcept : lane(all) {}
  template <class Number>
  requires std::is_arithmetic_v<Number>
  [[gnu::always_inline]] explicit lanes(Number same) noexcept : lane(static_cast<T>(same) - vector{}) {}

  /// W numbers from memory of any alignment, and back.
  [[nodiscard, gnu::always_inline]] static lanes load(const T* from) noexcept {
    lanes all;
    __builtin_memcpy(&all.lane, from, sizeof(all.lane));
    return all;
  }
  [[gnu::always_inline]] void store(T* to) const noexcept { __builtin_memcpy(to, &lane, sizeof(lane)); }

  [[nodiscard, gnu::always_inline]] friend lanes operator+(lanes a, lanes b) noexcept { return lanes(a.lane + b.lane); }
  [[nodiscard, gnu::always_inline]] friend lanes operator-(lanes a, lanes b) noexcept { return lanes(a.lane - b.lane); }
  [[nodiscard, gnu::always_inline]] friend lanes operator*(lanes a, lanes b) noexcept { return lanes(a.lane * b.lane); }
  [[nodiscard, gnu::always_inline]] friend lanes operator/(lanes a, lanes b) noexcept { return lanes(a.lane / b.lane); }
  [[nodiscard, gnu::always_inline]] friend lanes operator&(lanes a, lanes b) noexcept { return lanes(a.lane & b.lane); }
  [[nodiscard, gnu::always_inline]] friend lanes operator<<(lanes a, int n) noexcept { return lanes(a.lane << n); }
  [[nodiscard, gnu::always_inline]] friend lanes operator>>(lanes a, int n) noexcept { return lanes(a.lane >> n); }
  [[nodiscard, gnu::always_inline]] friend mask operator<(lanes a, lanes b) noexcept { return {a.lane < b.lane}; }
  [[nodiscard, gnu::always_inline]] friend mask operator>(lanes a, lanes b) noexcept { return {a.lane > b.lane}; }
  [[nodiscard, gnu::always_inline]] friend mask operator<=(lanes a, lanes b) noexcept { return {a.lane <= b.lane}; }
  [[nodiscard, gnu::always_inline]] friend mask operator>=(lanes a, lanes b) noexcept { return {a.lane >= b.lane}; }
  [[nodiscard, gnu::always_inline]] friend mask operator!=(lanes a, lanes b) noexcept { return {a.lane != b.lane}; }
};

template <int W, class T>
struct number_parts<lanes<W, T>> {
  using each = T;
  template <class Other>
  using as_many = lanes<W, Other>;
};

/// W points or directions.
template <int W>
using lane_vector = glm::vec<3, lanes<W>, glm::defaultp>;

/// A mask as a number: bit k is set where the comparison holds for lane k.
template <int W>
[[nodiscard, gnu::always_inline]] inline std::uint32_t bits(lane_mask<W> mask) noexcept;

/// The same number where it holds for all.
template <int W>
[[nodiscard]] constexpr std::uint32_t all_bits() noexcept {
  return (1u << W) - 1u;
}

/// The same bytes as other lanes.
template <class To, int W, class T>
[[nodiscard, gnu::always_inline]] inline To bits_as(lanes<W, T> x) noexcept {
  return To(reinterpret_cast<typename To::vector>(x.lane));
}

/// The functions of core/real_number.hpp and core/elementary.hpp that a packed type brings along.
template <int W>
[[nodiscard, gnu::always_inline]] inline bool holds_for_any(lane_mask<W> condition) noexcept {
  return bits(condition) != 0u;
}
template <int W>
[[nodiscard, gnu::always_inline]] inline bool holds_for_all(lane_mask<W> condition) noexcept {
  return bits(condition) == all_bits<W>();
}
template <int W, class T>
[[nodiscard, gnu::always_inline]] inline lanes<W, T> select(typename lanes<W, T>::mask condition, lanes<W, T> a,
                                                            lanes<W, T> b) noexcept {
  return lanes<W, T>(condition.lane ? a.lane : b.lane);
}
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> square_root(lanes<W> x) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W, int> bits_of(lanes<W> x) noexcept {
  return bits_as<lanes<W, int>>(x);
}
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> float_of_bits(lanes<W, int> bits) noexcept {
  return bits_as<lanes<W>>(bits);
}
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W, int> to_integer(lanes<W> x) noexcept {
  return lanes<W, int>(__builtin_convertvector(x.lane, typename lanes<W>::integers));
}
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W, std::uint32_t> to_natural(lanes<W> x) noexcept {
  return lanes<W, std::uint32_t>(__builtin_convertvector(x.lane, typename lanes<W>::naturals));
}
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> to_float(lanes<W, int> x) noexcept {
  return lanes<W>(__builtin_convertvector(x.lane, typename lanes<W>::vector));
}
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> whole_part(lanes<W> x) noexcept {
  return to_float(to_integer(x));
}

/// The sum of all lanes by add_saturating().
template <int W>
[[nodiscard, gnu::always_inline]] inline std::uint32_t sum_saturating(lanes<W, std::uint32_t> x) noexcept;

// ---------------------------------------------------------------------------------------------------------

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
#if defined(__SSE2__)
  if constexpr (W == 4) {
    return static_cast<std::uint32_t>(_mm_movemask_ps(__m128(mask.lane)));
  }
#elif defined(__aarch64__)
  if constexpr (W == 4) {
    return vaddvq_u32(uint32x4_t(mask.lane) & uint32x4_t{1u, 2u, 4u, 8u});
  }
#endif
  std::uint32_t set = 0u;
  for (int k = 0; k < W; ++k) {
    set |= mask.lane[k] != 0 ? 1u << k : 0u;
  }
  return set;
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
#if defined(__SSE2__)
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
std::uint32_t sum_saturating(lanes<W, std::uint32_t> x) noexcept {
  std::uint32_t sum = x.lane[0];
  for (int k = 1; k < W; ++k) {
    sum = add_saturating(sum, x.lane[k]);
  }
  return sum;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
