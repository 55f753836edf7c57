// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "glsl/double_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace pelage::test {

namespace {

/// The largest relative errors seen, printed at the end of the program where PELAGE_TABLE is set.
struct error_table {
  struct line {
    std::string function;
    double error;
  };
  std::vector<line> lines;

  void note(const char* function, double error) {
    for (line& l : lines) {
      if (l.function == function) {
        l.error = std::max(l.error, error);
        return;
      }
    }
    lines.push_back({function, error});
  }

  ~error_table() {
    if (std::getenv("PELAGE_TABLE") == nullptr || lines.empty()) return;
    std::printf("| function | largest relative error against double on %s |\n| --- | --- |\n",
                the_device()->name().c_str());
    for (const line& l : lines)
      std::printf("| `%s` | %.2g |\n", l.function.c_str(), l.error);
  }
};

error_table& the_table() {
  static error_table t;
  return t;
}

double relative_error(double expected, double got, double floor) {
  if (std::isnan(expected) || expected == got) return std::isnan(expected) == std::isnan(got) ? 0.0 : HUGE_VAL;
  const double error = std::abs(got - expected) / std::max(std::abs(expected), floor);
  return std::isfinite(error) ? error : HUGE_VAL;
}

constexpr double skipped = -HUGE_VAL;

}  // namespace

void wanted::put(const glm::dvec3& v) {
  put(std::array<double, 3>{v.x, v.y, v.z});
}

void wanted::put(const std::array<double, 3>& v) {
  values_.insert(values_.end(), v.begin(), v.end());
}

void wanted::skip(std::size_t words) {
  values_.insert(values_.end(), words, skipped);
}

void compare_with_double(const kernel& k, const std::vector<rc::Gen<std::uint32_t>>& inputs,
                         const std::function<void(row, row, wanted&)>& reference,
                         const std::vector<accuracy>& columns) {
  std::size_t width = 0;
  for (const accuracy& c : columns)
    width += c.words;
  const run_rows run = run_over(k, inputs, width);
  for (std::size_t r = 0; r < run.rows; ++r) {
    wanted expected;
    reference(run.inputs(r), run.results(r), expected);
    RC_ASSERT(expected.values().size() == width);
    std::size_t at = 0;
    for (const accuracy& c : columns) {
      for (std::size_t i = 0; i < c.words; ++i, ++at) {
        const double value = expected.values()[at];
        if (value == skipped) continue;
        const double got = static_cast<double>(run.results(r).f(at));
        const double error = relative_error(value, got, c.floor);
        the_table().note(c.function, error);
        if (error <= c.bound) continue;
        char text[160];
        std::snprintf(text, sizeof text, ", part %zu on %s off by %.3g: expected %.17g got %.9g, given", i,
                      the_device()->name().c_str(), error, value, got);
        RC_FAIL(std::string(k.name) + ", " + c.function + text + as_text(run.inputs(r)));
      }
    }
  }
}

}  // namespace pelage::test
