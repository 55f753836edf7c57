// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <glm/vec3.hpp>

namespace rejected {

double in_double(double x) noexcept {  // error: double: the mirror computes in float
  return x;
}

float through_double(float x) noexcept {
  return static_cast<float>(x * 0.5);  // error: double: the mirror computes in float
}

long undeclared_wide(int x) noexcept {  // error: 64-bit integer that is not declared as std::uint64_t or std::int64_t
  return x;  // error: widened to 64 bits where that is not declared: write static_cast<std::uint64_t>
}

std::uint64_t silently_widened(std::uint32_t x) noexcept {
  return x;  // error: widened to 64 bits where that is not declared: write static_cast<std::uint64_t>
}

std::size_t size_arithmetic(std::uint32_t x) noexcept {  // error: 64-bit integer that is not declared as std::uint64_t or std::int64_t but as size_t
  return x + std::size_t{1};  // error: widened to 64 bits where that is not declared: write static_cast<std::uint64_t>
}

unsigned char byte(unsigned char x) noexcept {  // error: 8- or 16-bit integer: use int or std::uint32_t
  return x;
}

short sixteen_bits(short x) noexcept {  // error: 8- or 16-bit integer: use int or std::uint32_t
  return x;
}

std::uint32_t cut_to_eight_bits() noexcept {
  return static_cast<std::uint8_t>(300);  // error: 8- or 16-bit integer: use int or std::uint32_t
}

int cut_to_sixteen_bits() noexcept {
  return static_cast<std::int16_t>(-70000);  // error: 8- or 16-bit integer: use int or std::uint32_t
}

float through_a_pointer(const float* x) noexcept {  // error: pointer
  return *x;  // error: pointer
}

float c_array(int i) noexcept {
  const float table[2] = {1.0f, 2.0f};  // error: C array: use std::array | list of values
  return table[i];  // error: C array: use std::array
}

std::optional<int> optional(int x) noexcept {  // error: std::optional is not in the subset
  return x;  // error: constructor of std::optional: only aggregates are in the subset
}

int length_of(std::string text) noexcept {  // error: std::basic_string is not in the subset
  return static_cast<int>(text.size());  // error: std::basic_string<char>::size has no GLSL form here
}

glm::dvec3 double_vector(glm::dvec3 v) noexcept {  // error: double: the mirror computes in float
  return v;
}

int sum(std::span<const int> items) noexcept {  // error: std::span is not in the subset
  int total = 0;
  for (int x : items) total += x;  // error: range-for over something other than a std::array
  return total;
}

int& reference(int& x) noexcept {  // error: reference as a result: return a value
  return x;
}

int moved(int&& x) noexcept {  // error: rvalue reference
  return x;
}

}  // namespace rejected
