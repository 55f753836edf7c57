// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/math.hpp>

#include <cstdint>

namespace pelage {

/// Transmittances multiply; their logarithms add; and integers add to the same sum in any order. An optical depth
/// here is -log₂ of a transmittance in units of 2⁻²⁰, unsigned 32-bit.
///
/// Range [0, 4096) octaves. One fragment counts at most 32 octaves (an opaque one). Sums saturate at the end of the
/// range, which is still the same in any order, and read as 0, as does every sum above 126 octaves. Each fragment
/// rounds by at most 2⁻²¹ octaves, a relative error of 3.4e-7 in the product; fast_log2 adds its own, 1e-7 octaves
/// or 1e-7 of them. `alpha`: clamped to [0, 1]; NaN counts as 0.
[[nodiscard]] constexpr std::uint32_t optical_depth(float alpha) noexcept;

/// x in units of 2⁻²⁰, rounded to the nearest; 0 for negative and NaN, the greatest number from 4096 on.
[[nodiscard]] constexpr std::uint32_t to_fixed(float x) noexcept;

/// The transmittance of a sum, [0, 1]; exactly 1 for 0. Relative error below 1e-7 · (1 + octaves / 2).
[[nodiscard]] constexpr float transmittance_of(std::uint32_t optical) noexcept;

// ---------------------------------------------------------------------------------------------------------

constexpr std::uint32_t optical_depth(float alpha) noexcept {
  const float octaves = -fast_log2(1.0f - saturate(alpha));
  return to_fixed(octaves < 32.0f ? octaves : 32.0f);
}

constexpr std::uint32_t to_fixed(float x) noexcept {
  if (!(x > 0.0f)) {
    return 0u;
  }
  if (x >= 4096.0f) {
    return 0xffffffffu;
  }
  // From 2²³ units on a float is a whole number, and adding a half would round to even.
  const float units = x * 1048576.0f;
  return static_cast<std::uint32_t>(units < 8388608.0f ? units + 0.5f : units);
}

constexpr float transmittance_of(std::uint32_t optical) noexcept {
  return fast_exp2(-static_cast<float>(optical) * (1.0f / 1048576.0f));
}

}  // namespace pelage
