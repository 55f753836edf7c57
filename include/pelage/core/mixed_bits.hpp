// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/version.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// A number whose every bit depends on every bit of x; one to one, 0 stays 0. What looks random here comes from it,
/// so that it depends on what the caller names and is the same in every frame. ("lowbias32" of C. Wellons'
/// hash-prospector.)
[[nodiscard]] constexpr std::uint32_t mixed_bits(std::uint32_t x) noexcept;

// ---------------------------------------------------------------------------------------------------------

constexpr std::uint32_t mixed_bits(std::uint32_t x) noexcept {
  const std::uint32_t a = (x ^ (x >> 16u)) * 0x7feb352du;
  const std::uint32_t b = (a ^ (a >> 15u)) * 0x846ca68bu;
  return b ^ (b >> 16u);
}

}  // namespace pelage
