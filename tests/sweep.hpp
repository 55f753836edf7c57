// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <ostream>
#include <random>
#include <vector>

/// What the laws of formulas share: inputs spread evenly over a range, and the worst error seen on them.
namespace pelage::test {

/// The i-th point of a sequence that fills the unit cube evenly wherever it is cut off: the fractions of i / g,
/// i / g², ..., with g the root of gᴺ⁺¹ = g + 1.
template <std::size_t N>
std::array<double, N> even_point(int i) {
  static const double g = [] {
    double root = 1.5;
    for (int step = 0; step < 60; ++step) {
      root = std::pow(1.0 + root, 1.0 / static_cast<double>(N + 1));
    }
    return root;
  }();
  std::array<double, N> point;
  double x = i;
  for (double& coordinate : point) {
    x /= g;
    coordinate = x - std::floor(x);
  }
  return point;
}

/// Where u in [0, 1) falls in [lower, upper), spread evenly over the logarithm.
inline double on_log_scale(double u, double lower, double upper) {
  return lower * std::pow(upper / lower, u);
}

/// The unit vector that an even point of the square maps to, evenly over the sphere.
inline glm::dvec3 on_sphere(double u, double v) {
  const double z = 2.0 * u - 1.0;
  const double angle = 6.283185307179586 * v;
  const double radius = std::sqrt(1.0 - z * z);
  return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
}

/// The largest of many errors and the inputs that gave it. NaN is larger than any.
struct worst_case {
  double error = 0.0;
  std::vector<double> input;

  void see(double seen, std::initializer_list<double> from) {
    if (seen <= error) return;
    error = seen == seen ? seen : INFINITY;
    input = from;
  }

  friend std::ostream& operator<<(std::ostream& out, const worst_case& worst) {
    out.precision(17);
    out << "error " << worst.error << " at";
    for (const double x : worst.input) {
      out << ' ' << x;
    }
    return out;
  }
};

/// Makes a worst case worse: of random steps, each of one input by a tenth to a ten-millionth of itself, those are kept
/// whose error, which is 0 out of range, is larger.
template <class Error>
void climb(worst_case& worst, int steps, Error error) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int k = 0; k < steps; ++k) {
    std::vector<double> input = worst.input;
    input[random() % input.size()] *= 1.0 + std::pow(10.0, -1.0 - 6.0 * share(random)) * (2.0 * share(random) - 1.0);
    const double seen = error(input);
    if (seen > worst.error) {
      worst.error = seen;
      worst.input = input;
    }
  }
}

inline double relative_error(double value, double expected) {
  return value == expected ? 0.0 : std::abs(value - expected) / std::abs(expected);
}

}  // namespace pelage::test
