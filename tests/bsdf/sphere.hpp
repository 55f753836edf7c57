// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang.hpp>
#include <pelage/bsdf/longitudinal.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace pelage::test {

/// A unit vector by inclination and azimuth.
template <class Real>
glm::vec<3, Real> unit_vector(double theta, double phi) {
  return glm::vec<3, Real>(static_cast<Real>(std::sin(theta)), static_cast<Real>(std::cos(theta) * std::cos(phi)),
                           static_cast<Real>(std::cos(theta) * std::sin(phi)));
}

/// ∫ function(x) dx on [low, high] by four Gauss points in each of `panels` equal parts.
template <class Function>
double integrate(double low, double high, int panels, Function function) {
  constexpr std::array<double, 4> node = {-0.86113631159405258, -0.33998104358485626, 0.33998104358485626,
                                          0.86113631159405258};
  constexpr std::array<double, 4> weight = {0.34785484513745386, 0.65214515486254614, 0.65214515486254614,
                                            0.34785484513745386};
  const double half = 0.5 * (high - low) / panels;
  double sum = 0.0;
  for (int k = 0; k < panels; ++k) {
    for (std::size_t n = 0; n < 4; ++n) {
      sum += half * weight[n] * function(low + half * (2 * k + 1 + node[n]));
    }
  }
  return sum;
}

/// ∫ function(w) dω over the sphere: Gauss points in θ, the trapezium rule in φ.
template <class Real, class Function>
double integrate_sphere(int theta_panels, int phi_count, Function function) {
  return integrate(-0.5 * std::numbers::pi, 0.5 * std::numbers::pi, theta_panels, [&](double theta) {
    double row = 0.0;
    for (int k = 0; k < phi_count; ++k) {
      row += static_cast<double>(function(unit_vector<Real>(theta, 2.0 * std::numbers::pi * k / phi_count)));
    }
    return row * std::cos(theta) * 2.0 * std::numbers::pi / phi_count;
  });
}

/// A fixed stream of independent numbers in [0, 1).
struct number_stream {
  std::uint32_t state = 12345u;
  float operator()() {
    state = state * 1664525u + 1013904223u;
    std::uint32_t x = state;
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    x ^= x >> 16u;
    return static_cast<float>(x >> 8u) * 0x1p-24f;
  }
  /// What a sampler takes.
  std::array<float, 4> four() {
    std::array<float, 4> u;
    for (float& one : u)
      one = (*this)();
    return u;
  }
};

/// The sphere in 96 cells of equal area.
struct sphere_cells {
  static constexpr int rows = 8;
  static constexpr int columns = 12;
  std::vector<double> count = std::vector<double>(rows * columns);

  double& at(double x, double azimuth) {
    const int row = std::min(static_cast<int>((x + 1.0) * 0.5 * rows), rows - 1);
    const double turns = azimuth / (2.0 * std::numbers::pi);
    const int column = std::min(static_cast<int>((turns - std::floor(turns)) * columns), columns - 1);
    return count[static_cast<std::size_t>(row * columns + column)];
  }
  double& at(const glm::vec3& w) { return at(w.x, std::atan2(static_cast<double>(w.z), static_cast<double>(w.y))); }
};

/// By how many standard deviations χ² lies above its mean. Cells that expect fewer than 10 are counted as one.
inline double chi_square_excess(const sphere_cells& observed, const sphere_cells& expected) {
  double chi2 = 0.0, rest_observed = 0.0, rest_expected = 0.0;
  int cells = -1;
  const auto count = [&](double seen, double wanted) {
    chi2 += (seen - wanted) * (seen - wanted) / wanted;
    ++cells;
  };
  for (std::size_t k = 0; k < observed.count.size(); ++k) {
    if (expected.count[k] < 10.0) {
      rest_observed += observed.count[k];
      rest_expected += expected.count[k];
    } else {
      count(observed.count[k], expected.count[k]);
    }
  }
  // Where next to nothing is expected next to nothing may come.
  if (rest_expected + rest_observed > 10.0) count(rest_observed, std::max(rest_expected, 1.0));
  return (chi2 - cells) / std::sqrt(2.0 * std::max(cells, 1));
}

/// Panels per half circle and points per circle that resolve a fibre's narrowest lobes.
template <class Real>
int theta_panels_for(const chiang_fibre<Real>& fibre) {
  const double deviation = std::sqrt(static_cast<double>(fibre.longitudinal[1].variance));
  return static_cast<int>(std::numbers::pi / std::min(deviation, 0.05) * 0.5) + 1;
}

template <class Real>
int phi_count_for(const chiang_fibre<Real>& fibre) {
  return static_cast<int>(2.0 * std::numbers::pi / std::min(static_cast<double>(fibre.azimuthal.scale), 0.05) * 1.1) +
         1;
}

}  // namespace pelage::test
