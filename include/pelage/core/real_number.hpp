// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/version.hpp>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace pelage::inline PELAGE_ABI {

/// What a number is made of: itself alone, or numbers of one type in a pack such as core/lanes.hpp's.
template <class T>
struct number_parts {
  using each = T;
  template <class Other>
  using as_many = Other;
};

/// A number that a formula can be written in once: float, a wider floating-point type, or a pack of floats. Such a
/// formula chooses by select() where it would branch on data; packed types overload the functions below.
template <class T>
concept real_number = std::floating_point<typename number_parts<T>::each>;

/// float or a pack of floats, for formulas that work on a float's bits.
template <class T>
concept single_precision = std::same_as<float, typename number_parts<T>::each>;

/// std::uint32_t or a pack of it.
template <class T>
concept natural_number = std::same_as<typename number_parts<T>::each, std::uint32_t>;

/// As many integers as a number has parts.
template <class Number>
using integer_of = typename number_parts<Number>::template as_many<int>;
template <class Number>
using natural_of = typename number_parts<Number>::template as_many<std::uint32_t>;

/// a where the condition holds, else b. Both are evaluated.
template <std::floating_point Real>
[[nodiscard]] constexpr Real select(bool condition, Real a, Real b) noexcept {
  return condition ? a : b;
}
[[nodiscard]] constexpr std::uint32_t select(bool condition, std::uint32_t a, std::uint32_t b) noexcept {
  return condition ? a : b;
}

/// True if a condition holds for any number of a pack, or for all. Lets a formula leave out a part that none needs.
[[nodiscard]] constexpr bool holds_for_any(bool condition) noexcept {
  return condition;
}
[[nodiscard]] constexpr bool holds_for_all(bool condition) noexcept {
  return condition;
}

/// √x; a negative x or NaN gives NaN.
template <std::floating_point Real>
[[nodiscard, gnu::always_inline]] inline Real square_root(Real x) noexcept {
  return std::sqrt(x);
}

/// The bits of a float, and the float that has them.
[[nodiscard]] constexpr int bits_of(float x) noexcept {
  return std::bit_cast<int>(x);
}
[[nodiscard]] constexpr float float_of_bits(int bits) noexcept {
  return std::bit_cast<float>(bits);
}

/// x without its fraction, towards 0; |x| < 2³¹, for a natural number x in [0, 2³²).
[[nodiscard]] constexpr int to_integer(float x) noexcept {
  return static_cast<int>(x);
}
[[nodiscard]] constexpr std::uint32_t to_natural(float x) noexcept {
  return static_cast<std::uint32_t>(x);
}

/// The float next to x, ties to even.
[[nodiscard]] constexpr float to_float(int x) noexcept {
  return static_cast<float>(x);
}

}  // namespace pelage
