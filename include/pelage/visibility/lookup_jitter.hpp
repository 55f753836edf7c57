// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/mixed_bits.hpp>

#include <glm/vec2.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// An offset for a look-up in a map, in texels, [-½, ½) on each axis: added to the place that a fragment looks up, it
/// turns the steps between texels into noise of half a texel, where filtering would read four. [Sintorn & Assarsson
/// 2009, §3.3] Even over the square, so that the texel it leads to is each of the four round the place as often as
/// bilinear filtering weighs it: the mean over many seeds is the filtered value. The same for the same seed: name what
/// does not change from frame to frame, such as a fragment's id mixed with its pixel's number.
[[nodiscard]] inline glm::vec2 lookup_jitter(std::uint32_t seed) noexcept {
  const std::uint32_t x = mixed_bits(seed + 0x9e3779b9u);
  const std::uint32_t y = mixed_bits(x + 0x9e3779b9u);
  return glm::vec2(static_cast<float>(x >> 8u) * (1.0f / 16777216.0f) - 0.5f,
                   static_cast<float>(y >> 8u) * (1.0f / 16777216.0f) - 0.5f);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
