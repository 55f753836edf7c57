// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

#include <array>
#include <functional>
#include <vector>

#include "glsl/comparison.hpp"

namespace pelage::test {

/// A row of what a kernel must give, in double and in the kernel's order.
class wanted {
 public:
  void put(double value) { values_.push_back(value); }
  void put(const glm::dvec3& v);
  void put(const std::array<double, 3>& v);
  /// What has no precise value here, such as a sum over roots where two of them meet: not compared.
  void skip(std::size_t words);
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

 private:
  std::vector<double> values_;
};

/// How near to double one function of a kernel is, on every device.
struct accuracy {
  const char* function;  ///< as the table names it
  std::size_t words;     ///< of its result
  double bound;          ///< largest relative error of each word
  double floor = 1e-30;  ///< the error of lesser results is relative to this
};

/// Runs a kernel as run_over() and compares each word with what `reference` computes in double from the same inputs.
/// The reference sees the kernel's row of results as well, for checks of its own. NaN equals NaN.
void compare_with_double(const kernel& k, const std::vector<rc::Gen<std::uint32_t>>& inputs,
                         const std::function<void(row, row, wanted&)>& reference, const std::vector<accuracy>& columns);

}  // namespace pelage::test
