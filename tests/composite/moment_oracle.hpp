// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/optical_depth.hpp>

#include "composite/layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// What the tests of moments compare with, by long double and brute force.
namespace pelage::test {

/// A fragment of a pixel whose depths have the range [0, 1].
struct absorber {
  float relative;
  std::uint32_t amount;
};

inline std::vector<absorber> draw_absorbers(std::size_t least, std::size_t most) {
  std::vector<absorber> all(*rc::gen::inRange<std::size_t>(least, most + 1u));
  for (absorber& each : all) {
    each = {draw_share(), optical_depth(draw_share())};
  }
  if (!all.empty()) all.front().relative = 0.0f;
  if (all.size() > 1u) all.back().relative = 1.0f;
  return all;
}

/// Of absorbers put in one after the other.
template <class Moments>
Moments moments_of(const std::vector<absorber>& all) {
  auto moments = Moments::empty();
  for (const absorber& each : all) {
    moments.add(each.relative, each.amount);
  }
  return moments;
}

inline long double position_of(const absorber& each) {
  return std::min(1.0L, std::max(-1.0L, 2.0L * each.relative - 1.0L));
}

inline double amount_before(const std::vector<absorber>& all, float relative) {
  double sum = 0.0;
  for (const absorber& each : all) {
    sum += each.relative < relative ? double{static_cast<float>(each.amount)} : 0.0;
  }
  return sum;
}

/// What an amount lets through.
inline double passed(double amount) {
  return std::exp2(-amount / 1048576.0);
}

struct node {
  long double position;
  long double weight;
};

/// Solves a system of equations by Gauss's elimination with pivots; the right hand side is the last column.
template <std::size_t N>
std::array<long double, N> solve(std::array<std::array<long double, N + 1>, N> rows) {
  for (std::size_t i = 0; i < N; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i; j < N; ++j) {
      if (std::abs(rows[j][i]) > std::abs(rows[pivot][i])) pivot = j;
    }
    std::swap(rows[i], rows[pivot]);
    for (std::size_t j = 0; j < N; ++j) {
      if (j == i) continue;
      const long double factor = rows[j][i] / rows[i][i];
      for (std::size_t c = i; c <= N; ++c)
        rows[j][c] -= factor * rows[i][c];
    }
  }
  std::array<long double, N> x;
  for (std::size_t i = 0; i < N; ++i)
    x[i] = rows[i][N] / rows[i][i];
  return x;
}

/// The distribution of N / 2 + 1 nodes that has the N moments of all and one node at a depth, nearest first: its nodes
/// are the roots of det of the bordered Hankel matrix, its weights solve the moments' equations.
template <std::uint32_t N>
std::vector<node> representing_measure(const std::vector<absorber>& all, float relative) {
  constexpr std::size_t n = N / 2u;
  std::array<long double, N + 1u> moment{};
  for (const absorber& each : all) {
    for (std::size_t k = 0; k <= N; ++k)
      moment[k] += each.amount * std::pow(position_of(each), k);
  }
  const long double here = 2.0L * relative - 1.0L;
  std::array<std::array<long double, n + 2>, n + 1> hankel;
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j)
      hankel[i][j] = moment[i + j];
    hankel[i][n + 1] = std::pow(here, i);
  }
  const auto kernel = solve<n + 1>(hankel);
  // Durand and Kerner's iteration for the roots of the kernel.
  std::array<std::complex<long double>, n> root;
  for (std::size_t i = 0; i < n; ++i)
    root[i] = std::pow(std::complex<long double>(0.4L, 0.9L), i);
  for (int step = 0; step < 2000; ++step) {
    for (std::size_t i = 0; i < n; ++i) {
      std::complex<long double> value = 1.0L;
      for (std::size_t k = n; k-- > 0;)
        value = value * root[i] + kernel[k] / kernel[n];
      for (std::size_t j = 0; j < n; ++j) {
        if (j != i) value /= root[i] - root[j];
      }
      root[i] -= value;
    }
  }
  std::vector<node> nodes{{here, 0.0L}};
  for (const auto& each : root)
    nodes.push_back({each.real(), 0.0L});
  std::array<std::array<long double, n + 2>, n + 1> equations;
  for (std::size_t k = 0; k <= n; ++k) {
    for (std::size_t i = 0; i <= n; ++i)
      equations[k][i] = std::pow(nodes[i].position, k);
    equations[k][n + 1] = moment[k];
  }
  const auto weight = solve<n + 1>(equations);
  for (std::size_t i = 0; i <= n; ++i)
    nodes[i].weight = weight[i];
  std::sort(nodes.begin(), nodes.end(), [](const node& a, const node& b) { return a.position < b.position; });
  return nodes;
}

/// The weight of the node at a depth.
inline long double nodes_at(const std::vector<node>& nodes, float relative) {
  const auto nearest = std::min_element(nodes.begin(), nodes.end(), [&](const node& a, const node& b) {
    const long double here = 2.0L * relative - 1.0L;
    return std::abs(a.position - here) < std::abs(b.position - here);
  });
  return nearest->weight;
}

}  // namespace pelage::test
