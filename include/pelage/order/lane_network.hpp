// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/vector_lanes.hpp>

#include <cstdint>

/// Sorting networks over an array of vectors, for k_select. Element e of n = Rows × lanes stands in lane e / Rows of
/// row e % Rows: a sequence runs down each lane, then goes on in the next, so most compares need no shuffle. The same
/// instructions whatever the data; no element may be NaN. O(n log² n).
namespace pelage::lane_network {

/// Sorts the elements, least first.
template <class Lanes, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void sort(Vector (&row)[Rows]) noexcept;

/// Puts in `a` the n least of both, sorted. Both sorted.
template <class Lanes, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void keep_least(Vector (&a)[Rows], const Vector (&b)[Rows]) noexcept;

/// The greatest of the lesser half of the elements. Leaves them in no order.
template <class Lanes, class Vector, std::uint32_t Rows>
[[nodiscard, gnu::always_inline]] inline auto lower_median(Vector (&row)[Rows]) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <class Lanes, class Vector>
[[gnu::always_inline]] inline void order(Vector& a, Vector& b) noexcept {
  const Vector lesser = Lanes::min(a, b);
  b = Lanes::max(a, b);
  a = lesser;
}

/// Batcher's merge of rows First, First + Stride, … below First + N, whose even and odd halves are sorted.
template <class Lanes, std::uint32_t First, std::uint32_t N, std::uint32_t Stride, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void merge_rows(Vector (&row)[Rows]) noexcept {
  if constexpr (2u * Stride < N) {
    merge_rows<Lanes, First, N, 2u * Stride>(row);
    merge_rows<Lanes, First + Stride, N, 2u * Stride>(row);
    unroll<N / (2u * Stride) - 1u>([&](auto i) __attribute__((always_inline)) {
      order<Lanes>(row[First + Stride + 2u * Stride * i], row[First + 2u * Stride + 2u * Stride * i]);
    });
  } else {
    order<Lanes>(row[First], row[First + Stride]);
  }
}

/// Sorts each lane by itself.
template <class Lanes, std::uint32_t First, std::uint32_t N, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void sort_rows(Vector (&row)[Rows]) noexcept {
  if constexpr (N > 1u) {
    sort_rows<Lanes, First, N / 2u>(row);
    sort_rows<Lanes, First + N / 2u, N / 2u>(row);
    merge_rows<Lanes, First, N, 1u>(row);
  }
}

/// Sorts groups of 2 D lanes that hold a bitonic sequence each.
template <class Lanes, std::uint32_t D, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void sort_bitonic(Vector (&row)[Rows]) noexcept {
  if constexpr (D >= 1u) {
    unroll<Rows>([&](auto r) __attribute__((always_inline)) {
      const Vector other = Lanes::template flip<D>(row[r]);
      row[r] = Lanes::template pick<D>(Lanes::min(row[r], other), Lanes::max(row[r], other));
    });
    sort_bitonic<Lanes, D / 2u>(row);
  } else {
    constexpr auto halve = []<std::uint32_t Distance>(
        auto self, Vector(&v)[Rows], std::integral_constant<std::uint32_t, Distance>) __attribute__((always_inline)) {
      if constexpr (Distance >= 1u) {
        unroll<Rows / 2u>([&](auto i) __attribute__((always_inline)) {
          constexpr std::uint32_t r = i / Distance * 2u * Distance + i % Distance;
          order<Lanes>(v[r], v[r + Distance]);
        });
        self(self, v, std::integral_constant<std::uint32_t, Distance / 2u>{});
      }
    };
    halve(halve, row, std::integral_constant<std::uint32_t, Rows / 2u>{});
  }
}

/// Merges sorted groups of D lanes in pairs, then those, until groups of `End` lanes are sorted.
template <class Lanes, std::uint32_t D, std::uint32_t End, class Vector, std::uint32_t Rows>
[[gnu::always_inline]] inline void merge_lanes(Vector (&row)[Rows]) noexcept {
  if constexpr (D < End) {
    constexpr std::uint32_t across = 2u * D - 1u;
    if constexpr (Rows == 1u) {
      const Vector other = Lanes::template flip<across>(row[0]);
      row[0] = Lanes::template pick<D>(Lanes::min(row[0], other), Lanes::max(row[0], other));
    } else {
      // Row r meets the mirror image of row Rows - 1 - r; one min and one max serve both.
      unroll<Rows / 2u>([&](auto r) __attribute__((always_inline)) {
        const Vector other = Lanes::template flip<across>(row[Rows - 1u - r]);
        const Vector lesser = Lanes::min(row[r], other);
        const Vector greater = Lanes::max(row[r], other);
        row[r] = Lanes::template pick<D>(lesser, greater);
        row[Rows - 1u - r] = Lanes::template flip<across>(Lanes::template pick<D>(greater, lesser));
      });
    }
    sort_bitonic<Lanes, D / 2u>(row);
    merge_lanes<Lanes, 2u * D, End>(row);
  }
}

template <class Lanes, class Vector, std::uint32_t Rows>
inline void sort(Vector (&row)[Rows]) noexcept {
  sort_rows<Lanes, 0u, Rows>(row);
  merge_lanes<Lanes, 1u, Lanes::template count<Vector>>(row);
}

template <class Lanes, class Vector, std::uint32_t Rows>
inline void keep_least(Vector (&a)[Rows], const Vector (&b)[Rows]) noexcept {
  constexpr std::uint32_t lanes = Lanes::template count<Vector>;
  unroll<Rows>([&](auto r) __attribute__((always_inline)) {
    a[r] = Lanes::min(a[r], Lanes::template flip<lanes - 1u>(b[Rows - 1u - r]));
  });
  sort_bitonic<Lanes, lanes / 2u>(a);
}

template <class Lanes, class Vector, std::uint32_t Rows>
inline auto lower_median(Vector (&row)[Rows]) noexcept {
  constexpr std::uint32_t lanes = Lanes::template count<Vector>;
  sort_rows<Lanes, 0u, Rows>(row);
  merge_lanes<Lanes, 1u, lanes / 2u>(row);
  constexpr std::uint32_t pairs = Rows == 1u ? 1u : Rows / 2u;
  Vector greatest = Lanes::min(row[0], Lanes::template flip<lanes - 1u>(row[Rows - 1u]));
  unroll<pairs - 1u>([&](auto i) __attribute__((always_inline)) {
    constexpr std::uint32_t r = i + 1u;
    const Vector lesser = Lanes::min(row[r], Lanes::template flip<lanes - 1u>(row[Rows - 1u - r]));
    greatest = Lanes::max(greatest, lesser);
  });
  constexpr auto across = [](auto self, Vector v, auto d) __attribute__((always_inline)) {
    if constexpr (d >= 1u) {
      return self(self, Lanes::max(v, Lanes::template flip<d>(v)), std::integral_constant<std::uint32_t, d / 2u>{});
    } else {
      return v[0];
    }
  };
  return across(across, greatest, std::integral_constant<std::uint32_t, lanes / 2u>{});
}

}  // namespace pelage::lane_network
