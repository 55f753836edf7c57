// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace bench {

/// Pixels of equal length, one after the other, and the place for the K nearest of each.
struct workload {
  std::span<const pelage::fragment> fragments;
  std::span<const std::uint32_t> first;  ///< as k_select takes it
  std::span<pelage::fragment> nearest;
};

/// A way to select. run[i] does all pixels of a workload with K = k_values[i].
inline constexpr std::uint32_t k_values[] = {4u, 8u, 16u, 32u, 64u};
inline constexpr std::size_t k_count = 5u;
struct method {
  std::string name;
  bool ours;
  void (*run[k_count])(const workload&);
};

/// pelage::k_select as compiled for one instruction set each; k_select.cpp, compiled more than once.
extern const method k_select_sse2, k_select_avx2, k_select_avx512;

/// The others.
[[nodiscard]] std::vector<method> other_methods();

}  // namespace bench
