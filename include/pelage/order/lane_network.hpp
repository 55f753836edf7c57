// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/lane_moves.hpp>
#include <pelage/core/lanes.hpp>

#include <cstdint>
#include <type_traits>

/// Sorting networks over an array of vectors, for k_select. Element e of n = Rows × lanes stands in lane e / Rows of
/// row e % Rows: a sequence runs down each lane, then goes on in the next, so most compares need no shuffle. The same
/// instructions whatever the data; no element may be NaN. O(n log² n).
namespace pelage::inline PELAGE_ABI::lane_network {

/// Sorts the elements, least first.
template <int W, class T, std::uint32_t Rows>
[[gnu::always_inline]] inline void sort(lanes<W, T> (&row)[Rows]) noexcept;

/// Puts in `a` the n least of both, sorted. Both sorted.
template <int W, class T, std::uint32_t Rows>
[[gnu::always_inline]] inline void keep_least(lanes<W, T> (&a)[Rows], const lanes<W, T> (&b)[Rows]) noexcept;

/// The greatest of the lesser half of the elements. Leaves them in no order.
template <int W, class T, std::uint32_t Rows>
[[nodiscard, gnu::always_inline]] inline T lower_median(lanes<W, T> (&row)[Rows]) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <class Vector>
[[gnu::always_inline]] inline void order(Vector& a, Vector& b) noexcept {
  const Vector lesser = least(a, b);
  b = greatest(a, b);
  a = lesser;
}

/// Batcher's merge of rows First, First + Stride, … below First + N, whose even and odd halves are sorted.
template <std::uint32_t First, std::uint32_t N, std::uint32_t Stride, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void merge_rows(Vector (&row)[Rows]) noexcept {
  if constexpr (2u * Stride < N) {
    merge_rows<First, N, 2u * Stride>(row);
    merge_rows<First + Stride, N, 2u * Stride>(row);
    detail::unroll<N / (2u * Stride) - 1u>([&](auto i) __attribute__((always_inline)) {
      order(row[First + Stride + 2u * Stride * i], row[First + 2u * Stride + 2u * Stride * i]);
    });
  } else {
    order(row[First], row[First + Stride]);
  }
}

/// Sorts each lane by itself.
template <std::uint32_t First, std::uint32_t N, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void sort_rows(Vector (&row)[Rows]) noexcept {
  if constexpr (N > 1u) {
    sort_rows<First, N / 2u>(row);
    sort_rows<First + N / 2u, N / 2u>(row);
    merge_rows<First, N, 1u>(row);
  }
}

/// Sorts groups of 2 D lanes that hold a bitonic sequence each.
template <std::uint32_t D, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void sort_bitonic(Vector (&row)[Rows]) noexcept {
  if constexpr (D >= 1u) {
    detail::unroll<Rows>([&](auto r) __attribute__((always_inline)) {
      const Vector other = flipped<D>(row[r]);
      row[r] = alternated<D>(least(row[r], other), greatest(row[r], other));
    });
    sort_bitonic<D / 2u>(row);
  } else {
    constexpr auto halve = []<std::uint32_t Distance>(
        auto self, Vector(&v)[Rows], std::integral_constant<std::uint32_t, Distance>) __attribute__((always_inline)) {
      if constexpr (Distance >= 1u) {
        detail::unroll<Rows / 2u>([&](auto i) __attribute__((always_inline)) {
          constexpr std::uint32_t r = i / Distance * 2u * Distance + i % Distance;
          order(v[r], v[r + Distance]);
        });
        self(self, v, std::integral_constant<std::uint32_t, Distance / 2u>{});
      }
    };
    halve(halve, row, std::integral_constant<std::uint32_t, Rows / 2u>{});
  }
}

/// Merges sorted groups of D lanes in pairs, then those, until groups of `End` lanes are sorted.
template <std::uint32_t D, std::uint32_t End, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void merge_lanes(Vector (&row)[Rows]) noexcept {
  if constexpr (D < End) {
    constexpr std::uint32_t across = 2u * D - 1u;
    if constexpr (Rows == 1u) {
      const Vector other = flipped<across>(row[0]);
      row[0] = alternated<D>(least(row[0], other), greatest(row[0], other));
    } else {
      // Row r meets the mirror image of row Rows - 1 - r; one min and one max serve both.
      detail::unroll<Rows / 2u>([&](auto r) __attribute__((always_inline)) {
        const Vector other = flipped<across>(row[Rows - 1u - r]);
        const Vector lesser = least(row[r], other);
        const Vector greater = greatest(row[r], other);
        row[r] = alternated<D>(lesser, greater);
        row[Rows - 1u - r] = flipped<across>(alternated<D>(greater, lesser));
      });
    }
    sort_bitonic<D / 2u>(row);
    merge_lanes<2u * D, End>(row);
  }
}

template <int W, class T, std::uint32_t Rows>
inline void sort(lanes<W, T> (&row)[Rows]) noexcept {
  sort_rows<0u, Rows>(row);
  merge_lanes<1u, W>(row);
}

template <int W, class T, std::uint32_t Rows>
inline void keep_least(lanes<W, T> (&a)[Rows], const lanes<W, T> (&b)[Rows]) noexcept {
  detail::unroll<Rows>([&](auto r)
                           __attribute__((always_inline)) { a[r] = least(a[r], flipped<W - 1>(b[Rows - 1u - r])); });
  sort_bitonic<W / 2>(a);
}

template <int W, class T, std::uint32_t Rows>
inline T lower_median(lanes<W, T> (&row)[Rows]) noexcept {
  sort_rows<0u, Rows>(row);
  merge_lanes<1u, W / 2>(row);
  constexpr std::uint32_t pairs = Rows == 1u ? 1u : Rows / 2u;
  lanes<W, T> found = least(row[0], flipped<W - 1>(row[Rows - 1u]));
  detail::unroll<pairs - 1u>([&](auto i) __attribute__((always_inline)) {
    constexpr std::uint32_t r = i + 1u;
    found = greatest(found, least(row[r], flipped<W - 1>(row[Rows - 1u - r])));
  });
  constexpr auto across = [](auto self, lanes<W, T> v, auto d) __attribute__((always_inline)) {
    if constexpr (d >= 1) {
      return self(self, greatest(v, flipped<d>(v)), std::integral_constant<int, d / 2>{});
    } else {
      return v.lane[0];
    }
  };
  return across(across, found, std::integral_constant<int, W / 2>{});
}

}  // namespace pelage::lane_network
