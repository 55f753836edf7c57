// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <compare>
#include <cstdint>
#include <functional>
#include <numeric>

namespace rejected {

float round_halves(float x) noexcept {
  return std::round(x);  // error: round: GLSL leaves halves open
}

int greatest_divisor(int a, int b) noexcept {
  return std::gcd(a, b);  // error: std::gcd has no GLSL form here
}

int factorial(int n) noexcept {
  return n < 2 ? 1 : n * factorial(n - 1);  // error: recursion: rejected_factorial calls itself, directly or through others
}

bool odd(int n) noexcept;

bool even(int n) noexcept {
  return n == 0 ? true : odd(n - 1);
}

bool odd(int n) noexcept {
  return n == 0 ? false : even(n - 1);  // error: recursion: rejected_even calls itself, directly or through others
}

int nowhere(int x) noexcept;  // error: rejected::nowhere has no definition here

int calls_nowhere(int x) noexcept {
  return nowhere(x);
}

int lambda(int x) noexcept {
  const auto twice = [](int y) { return 2 * y; };  // error: lambda
  return twice(x);  // error: call through a pointer or of a callable object
}

int by_pointer(int (*f)(int), int x) noexcept {  // error: pointer
  return f(x);  // error: call through a pointer or of a callable object
}

int many(int n, ...) noexcept {  // error: variadic function
  return n;
}

int size_of(float x) noexcept {
  return static_cast<int>(sizeof(x));  // error: sizeof and alignof
}

int* allocates() {  // error: pointer
  return new int(1);  // error: allocation
}

int c_cast(float x) noexcept {
  return (int)x;  // error: C cast: use static_cast or T(x)
}

int punned(float x) noexcept {
  return reinterpret_cast<int&>(x);  // error: reinterpret_cast, const_cast and dynamic_cast
}

char letter() noexcept {  // error: 8- or 16-bit integer: use int or std::uint32_t
  return 'a';  // error: character or string
}

int counter = 0;

int reads_a_global() noexcept {
  return counter;  // error: global variable `counter` that is not constexpr
}

float double_literal(float x) noexcept {
  return x > 0.5 ? 1.0f : 0.0f;  // error: double literal: add `f`, or convert it with Real(...) | double: the mirror computes in float
}

bool three_ways(int a, int b) noexcept {
  return (a <=> b) < 0;  // error: operator overload: call a function instead
}

}  // namespace rejected
