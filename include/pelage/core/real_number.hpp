// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <concepts>
#include <type_traits>

namespace pelage {

/// True of a type that packs many floats, such as core/lanes.hpp's.
template <class T>
struct is_packed : std::false_type {};

/// A number that a formula can be written in once: float, a wider floating-point type, or a pack of floats. Such a
/// formula chooses by select() where it would branch on data; packed types overload the functions below.
template <class T>
concept real_number = std::floating_point<T> || is_packed<T>::value;

/// a where the condition holds, else b. Both are evaluated.
template <std::floating_point Real>
[[nodiscard]] constexpr Real select(bool condition, Real a, Real b) noexcept;

/// True if a condition holds for any number of a pack, or for all. Lets a formula leave out a part that none needs.
[[nodiscard]] constexpr bool holds_for_any(bool condition) noexcept;
[[nodiscard]] constexpr bool holds_for_all(bool condition) noexcept;

/// √x; a negative x or NaN gives NaN.
template <std::floating_point Real>
[[nodiscard, gnu::always_inline]] inline Real square_root(Real x) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
constexpr Real select(bool condition, Real a, Real b) noexcept {
  return condition ? a : b;
}

constexpr bool holds_for_any(bool condition) noexcept {
  return condition;
}

constexpr bool holds_for_all(bool condition) noexcept {
  return condition;
}

template <std::floating_point Real>
Real square_root(Real x) noexcept {
  return std::sqrt(x);
}

}  // namespace pelage
