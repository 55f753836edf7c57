// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <rapidcheck.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "glsl/device.hpp"

namespace pelage::test {

/// A row of a kernel's inputs, read as the kernel reads it.
struct row {
  std::span<const std::uint32_t> words;
  [[nodiscard]] std::uint32_t u(std::size_t i) const { return words[i]; }
  [[nodiscard]] float f(std::size_t i) const;
  [[nodiscard]] glm::vec3 v3(std::size_t i) const { return {f(i), f(i + 1), f(i + 2)}; }
  [[nodiscard]] glm::vec4 v4(std::size_t i) const { return {f(i), f(i + 1), f(i + 2), f(i + 3)}; }
  [[nodiscard]] double d(std::size_t i) const { return static_cast<double>(f(i)); }
  [[nodiscard]] glm::dvec3 d3(std::size_t i) const { return {d(i), d(i + 1), d(i + 2)}; }
  [[nodiscard]] std::array<double, 3> channels(std::size_t i) const { return {d(i), d(i + 1), d(i + 2)}; }
};

/// A row of results, filled in the kernel's order.
class results {
 public:
  void put(std::uint32_t value) { words_.push_back(value); }
  void put(bool value) { words_.push_back(value ? 1U : 0U); }
  void put(float value);
  void put(const glm::vec3& v);
  void put(const glm::vec4& v);
  [[nodiscard]] const std::vector<std::uint32_t>& words() const { return words_; }

 private:
  std::vector<std::uint32_t> words_;
};

/// Rows of inputs and what a kernel made of them.
struct run_rows {
  std::size_t rows;
  std::size_t stride;                ///< words of inputs in a row
  std::size_t width;                 ///< words of results in a row
  std::vector<std::uint32_t> given;  ///< rows * stride
  std::vector<std::uint32_t> got;    ///< rows * width
  [[nodiscard]] row inputs(std::size_t r) const { return {std::span(given).subspan(r * stride, stride)}; }
  [[nodiscard]] row results(std::size_t r) const { return {std::span(got).subspan(r * width, width)}; }
};

/// Runs a kernel over rows of `stride` words.
[[nodiscard]] run_rows run_over(const kernel& k, std::vector<std::uint32_t> given, std::size_t stride,
                                std::size_t width);

/// Runs a kernel over rows of `inputs`, whole columns drawn by rapidcheck.
[[nodiscard]] run_rows run_over(const kernel& k, const std::vector<rc::Gen<std::uint32_t>>& inputs, std::size_t width);

/// A row of inputs as text.
[[nodiscard]] std::string as_text(row inputs);

/// What one function of a kernel gives, and how far a device may be off.
struct column {
  const char* function;  ///< as the table names it
  std::size_t words;     ///< of its result
  double cpu_ulps;       ///< bound on lavapipe; bits() means equal
  double gpu_ulps;       ///< bound on a GPU
  float scale = 0.0F;    ///< an ulp is one of the result or of this, whichever is larger
};

/// The bound of whole numbers: not one bit.
constexpr double bits() {
  return -1.0;
}

/// Runs a kernel as run_over() and compares each column of the results
/// with what `reference` computes here. Differences in floats are measured in ulps, those of a vector in ulps of its
/// largest part; NaN equals NaN, and results that are not above the smallest normal, before rounding, may be flushed
/// to 0.
void compare(const kernel& k, const std::vector<rc::Gen<std::uint32_t>>& inputs,
             const std::function<void(row, results&)>& reference, const std::vector<column>& columns);

/// Any float at all: special values, any bits, and ordinary numbers.
[[nodiscard]] rc::Gen<std::uint32_t> any_float();

/// The same without denormals, which a device may take for 0.
[[nodiscard]] rc::Gen<std::uint32_t> any_normal_float();

/// Floats in [low, high], evenly.
[[nodiscard]] rc::Gen<std::uint32_t> between(float low, float high);

/// Positive floats from 2^low to 2^high, each power of two as often.
[[nodiscard]] rc::Gen<std::uint32_t> magnitude(int low, int high);

/// Any word; few of them, so that equal ones meet.
[[nodiscard]] rc::Gen<std::uint32_t> any_word();
[[nodiscard]] rc::Gen<std::uint32_t> few_words();

}  // namespace pelage::test
