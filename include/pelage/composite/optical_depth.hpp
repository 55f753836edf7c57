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
/// rounds by at most 2⁻²¹ octaves, a relative error of 3.4e-7 in the product; fast_log2 adds 1.5e-7 octaves.
[[nodiscard]] constexpr std::uint32_t optical_depth(float alpha) noexcept;

/// The sum of two, held to the end of the range. Associative and commutative.
[[nodiscard]] constexpr std::uint32_t add_saturating(std::uint32_t a, std::uint32_t b) noexcept;

/// The transmittance of a sum, [0, 1]; exactly 1 for 0.
[[nodiscard]] constexpr float transmittance_of(std::uint32_t optical) noexcept;

// ---------------------------------------------------------------------------------------------------------

constexpr std::uint32_t optical_depth(float alpha) noexcept {
  const float octaves = -fast_log2(1.0f - saturate(alpha));
  const float held = octaves < 32.0f ? octaves : 32.0f;
  return static_cast<std::uint32_t>(held * 1048576.0f + 0.5f);
}

constexpr std::uint32_t add_saturating(std::uint32_t a, std::uint32_t b) noexcept {
  const std::uint32_t room = 0xffffffffu - a;
  return a + (b < room ? b : room);
}

constexpr float transmittance_of(std::uint32_t optical) noexcept {
  return fast_exp2(-static_cast<float>(optical) * (1.0f / 1048576.0f));
}

}  // namespace pelage
