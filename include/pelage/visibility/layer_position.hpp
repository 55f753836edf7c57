// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/version.hpp>

#include <cmath>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// Where a depth lies among the slices or layers of a map: a position of 2.25 is a quarter into the third one. The
/// functions here give positions in [0, layers] that never fall as depth grows, whole exactly at a layer's end, and
/// the same for a fragment that is put in and for a look-up. NaN gives 0.

namespace detail {

/// x clamped to [0, high]; NaN gives 0.
[[nodiscard]] constexpr float clamped_position(float x, float high) noexcept {
  return x > 0.0f ? (x < high ? x : high) : 0.0f;
}

/// How many widths long an offset is.
[[nodiscard]] constexpr float offset_in_widths(float offset, float width) noexcept {
  return width <= 8.50705917e37f ? offset / width : 0.0f;
}

}  // namespace detail

/// Equal slices over a texel's whole depth range [Kim & Neumann 2001; Sintorn & Assarsson 2009, §3.1, whose ⌊d N⌋ has
/// no slice for d = 1: layer_at() puts it in the last]. `relative`: depth_range::relative, [0, 1].
[[nodiscard]] constexpr float slice_position(float relative, std::uint32_t slices) noexcept {
  const float end = static_cast<float>(slices);
  return detail::clamped_position(relative * end, end);
}

/// Layers of equal width that begin at the texel's nearest depth [Yuksel & Keyser 2008, §3]. What lies beyond the
/// last goes to its end. `offset`: depth minus that nearest depth; negative: 0. `width`: of a layer, [0, inf] in the
/// same unit; with 0 everything behind the nearest depth lies beyond the last layer, with NaN and above 2¹²⁶ (a GPU
/// divides by no more) at 0.
[[nodiscard]] constexpr float equal_layer_position(float offset, float width, std::uint32_t layers) noexcept {
  return detail::clamped_position(detail::offset_in_widths(offset, width), static_cast<float>(layers));
}

/// The same with widths that grow linearly: width, 2 width, 3 width, ... [Yuksel & Keyser 2008, §4]
[[nodiscard]] inline float growing_layer_position(float offset, float width, std::uint32_t layers) noexcept {
  const float end = static_cast<float>(layers);
  // Layer k begins at k (k + 1) / 2 widths; where the root rounds up to its number, the part inside is clamped to 0.
  const float widths = detail::clamped_position(detail::offset_in_widths(offset, width), 0.5f * end * (end + 1.0f));
  const float layer = std::floor(0.5f * (std::sqrt(8.0f * widths + 1.0f) - 1.0f));
  const float inside = (widths - 0.5f * layer * (layer + 1.0f)) / (layer + 1.0f);
  return detail::clamped_position(layer + detail::clamped_position(inside, 1.0f), end);
}

/// The first layer's width for linearly growing layers that together are `extent` long. `layers`: [1, 65535].
[[nodiscard]] constexpr float growing_layer_width(float extent, std::uint32_t layers) noexcept {
  const float count = static_cast<float>(layers);
  return extent / (0.5f * count * (count + 1.0f));
}

/// The layer that a position lies in, [0, layers): the position's end belongs to the last. `position`: [0, layers].
[[nodiscard]] constexpr std::uint32_t layer_at(float position, std::uint32_t layers) noexcept {
  const std::uint32_t layer = static_cast<std::uint32_t>(position);
  return layer < layers ? layer : layers - 1u;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
