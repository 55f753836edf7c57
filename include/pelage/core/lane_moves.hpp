// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lanes.hpp>

#include <bit>
#include <cstdint>
#include <utility>

namespace pelage::inline PELAGE_ABI {

/// Moves between the lanes of vectors, on the CPU alone. No bit of a float changes, NaN included.

/// Lane i of the result is number Source(i) of a's lanes and then b's, Source a constant function.
template <auto Source, int W, class T>
[[nodiscard, gnu::always_inline]] inline lanes<W, T> shuffled(lanes<W, T> a, lanes<W, T> b) noexcept {
  return [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
    return lanes<W, T>(__builtin_shufflevector(a.lane, b.lane, Source(I)...));
  }
  (std::make_integer_sequence<int, W>{});
}

/// Lane i of the result is lane i ^ D of x.
template <int D, int W, class T>
[[nodiscard, gnu::always_inline]] inline lanes<W, T> flipped(lanes<W, T> x) noexcept {
  constexpr auto other = [](int i) { return i ^ D; };
  return shuffled<other>(x, x);
}

/// Lane i of the result is that of a where bit D of i is clear, that of b where it is set.
template <int D, int W, class T>
[[nodiscard, gnu::always_inline]] inline lanes<W, T> alternated(lanes<W, T> a, lanes<W, T> b) noexcept {
  constexpr auto side = [](int i) { return (i & D) == 0 ? i : i + W; };
  return shuffled<side>(a, b);
}

/// Lane k of the result is lane `from[k] & (W - 1)` of x.
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> picked(lanes<W> x, typename lanes<W>::integers from) noexcept;
template <int W>
[[nodiscard, gnu::always_inline]] inline typename lanes<W>::integers picked_integers(
    typename lanes<W>::integers x, typename lanes<W>::integers from) noexcept {
  return bits_of(picked(float_of_bits(lanes<W, int>(x)), from)).lane;
}

/// Lane k of the result is `from[at[k]]`, for every lane: an element that may be read, behind `from` or before it. Any
/// numbers of 4 bytes may lie there.
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> gathered(const float* from, typename lanes<W>::integers at) noexcept;

/// The lanes whose bit is set, moved to the front in their order; 0 behind them. set: [0, 2^W).
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> packed_left(std::uint32_t set, lanes<W> x) noexcept;

/// a[0], b[0], a[1], b[1], … : the first W of them, and the rest.
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> zip_low(lanes<W> a, lanes<W> b) noexcept {
  constexpr auto source = [](int i) { return i / 2 + i % 2 * W; };
  return shuffled<source>(a, b);
}
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> zip_high(lanes<W> a, lanes<W> b) noexcept {
  constexpr auto source = [](int i) { return W / 2 + i / 2 + i % 2 * W; };
  return shuffled<source>(a, b);
}

/// Every second lane of a, then of b: from the first on, and from the second on.
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> even_lanes(lanes<W> a, lanes<W> b) noexcept {
  constexpr auto source = [](int i) { return 2 * i; };
  return shuffled<source>(a, b);
}
template <int W>
[[nodiscard, gnu::always_inline]] inline lanes<W> odd_lanes(lanes<W> a, lanes<W> b) noexcept {
  constexpr auto source = [](int i) { return 2 * i + 1; };
  return shuffled<source>(a, b);
}

/// Lane k of row i goes to lane i of row k.
template <int W>
[[gnu::always_inline]] inline void transpose(lanes<W> (&rows)[W]) noexcept;

/// Writes a[0], b[0], c[0], d[0], a[1], … : 4 W floats.
template <int W>
[[gnu::always_inline]] inline void store_quads(lanes<W> a, lanes<W> b, lanes<W> c, lanes<W> d, float* to) noexcept;

/// Reads what store_quads() writes.
template <int W>
[[gnu::always_inline]] inline void load_quads(const float* from, lanes<W>& a, lanes<W>& b, lanes<W>& c,
                                              lanes<W>& d) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <int W>
lanes<W> picked(lanes<W> x, typename lanes<W>::integers from) noexcept {
#if defined(__AVX512F__)
  if constexpr (W == 16) {
    return lanes<W>(typename lanes<W>::vector(_mm512_maskz_permutexvar_ps(0xffff, __m512i(from), __m512(x.lane))));
  }
#endif
#if defined(__AVX2__)
  if constexpr (W == 8) {
    return lanes<W>(typename lanes<W>::vector(_mm256_permutevar8x32_ps(__m256(x.lane), __m256i(from))));
  }
#endif
  lanes<W> result;
  for (int k = 0; k < W; ++k) {
    result.lane[k] = x.lane[from[k] & (W - 1)];
  }
  return result;
}

template <int W>
lanes<W> gathered(const float* from, typename lanes<W>::integers at) noexcept {
#if defined(__AVX512F__)
  if constexpr (W == 16) {
    return lanes<W>(
        typename lanes<W>::vector(_mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xffff, __m512i(at), from, 4)));
  }
#endif
  lanes<W> result;
  for (int k = 0; k < W; ++k) {
    float one;
    __builtin_memcpy(&one, from + at[k], sizeof(one));
    result.lane[k] = one;
  }
  return result;
}

template <int W>
lanes<W> packed_left(std::uint32_t set, lanes<W> x) noexcept {
#if defined(__AVX512F__)
  if constexpr (W == 16) {
    return lanes<W>(typename lanes<W>::vector(_mm512_maskz_compress_ps(static_cast<__mmask16>(set), __m512(x.lane))));
  }
#endif
#if defined(__AVX2__) && defined(__BMI2__) && defined(__x86_64__)
  if constexpr (W == 8) {
    const std::uint64_t bytes = _pdep_u64(set, 0x0101010101010101u) * 0xffu;
    const std::uint64_t order = _pext_u64(0x0706050403020100u, bytes);
    const __m256i from = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(order)));
    const __m256i count = _mm256_set1_epi32(std::popcount(set));
    const __m256i used = _mm256_cmpgt_epi32(count, _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    return lanes<W>(typename lanes<W>::vector(
        _mm256_and_ps(_mm256_permutevar8x32_ps(__m256(x.lane), from), _mm256_castsi256_ps(used))));
  }
#endif
  lanes<W> result(0.0f);
  for (int k = 0; set != 0u; ++k, set &= set - 1u) {
    result.lane[k] = x.lane[std::countr_zero(set)];
  }
  return result;
}

template <int W>
void transpose(lanes<W> (&rows)[W]) noexcept {
#pragma GCC unroll 4
  for (int stage = 1; stage < W; stage *= 2) {
    lanes<W> next[W];
#pragma GCC unroll 8
    for (int i = 0; i < W / 2; ++i) {
      next[2 * i] = zip_low(rows[i], rows[i + W / 2]);
      next[2 * i + 1] = zip_high(rows[i], rows[i + W / 2]);
    }
#pragma GCC unroll 16
    for (int i = 0; i < W; ++i) {
      rows[i] = next[i];
    }
  }
}

template <int W>
void store_quads(lanes<W> a, lanes<W> b, lanes<W> c, lanes<W> d, float* to) noexcept {
  const lanes<W> ac_low = zip_low(a, c);
  const lanes<W> ac_high = zip_high(a, c);
  const lanes<W> bd_low = zip_low(b, d);
  const lanes<W> bd_high = zip_high(b, d);
  zip_low(ac_low, bd_low).store(to);
  zip_high(ac_low, bd_low).store(to + W);
  zip_low(ac_high, bd_high).store(to + 2 * W);
  zip_high(ac_high, bd_high).store(to + 3 * W);
}

template <int W>
void load_quads(const float* from, lanes<W>& a, lanes<W>& b, lanes<W>& c, lanes<W>& d) noexcept {
  const lanes<W> first = lanes<W>::load(from);
  const lanes<W> second = lanes<W>::load(from + W);
  const lanes<W> third = lanes<W>::load(from + 2 * W);
  const lanes<W> fourth = lanes<W>::load(from + 3 * W);
  const lanes<W> ac_low = even_lanes(first, second);
  const lanes<W> bd_low = odd_lanes(first, second);
  const lanes<W> ac_high = even_lanes(third, fourth);
  const lanes<W> bd_high = odd_lanes(third, fourth);
  a = even_lanes(ac_low, ac_high);
  b = even_lanes(bd_low, bd_high);
  c = odd_lanes(ac_low, ac_high);
  d = odd_lanes(bd_low, bd_high);
}

}  // namespace pelage
