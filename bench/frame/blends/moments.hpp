// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/alpha_layers.hpp>
#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/power_moments.hpp>
#include <pelage/composite/trigonometric_moments.hpp>
#include <pelage/visibility/depth_range.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "frame/order/layer.hpp"

namespace pelage::frame {

// What came after the papers, by the rules of unordered.hpp.

/// By what the moments of the pixel's optical depth tell of it before each layer. Moments: power_moments<N> or another
/// of its kind. Exact for one layer and, except for rounding, for two.
template <class Moments>
[[nodiscard]] glm::vec3 blend_moments(std::span<const layer> layers, const glm::vec3& background) {
  depth_range range = depth_range::empty();
  for (const layer& l : layers)
    range.extend(l.where.depth);
  Moments moments = Moments::empty();
  for (const layer& l : layers)
    moments.add(range.relative(l.where.depth), optical_depth(l.alpha));
  const auto told = moments.visibility();
  tail sum = empty_tail();
  for (const layer& l : layers) {
    const float before = told.amount_before_fragment(range.relative(l.where.depth), optical_depth(l.alpha));
    sum = add_weighted(sum, l.alpha, optical_weight(l.alpha, before), l.radiance);
  }
  return resolve(sum, background);
}

/// As N layers that arrive by ascending id.
template <std::uint32_t N>
[[nodiscard]] glm::vec3 blend_layers(std::span<const layer> layers, const glm::vec3& background) {
  static thread_local std::vector<layer> arriving;
  arriving.assign(layers.begin(), layers.end());
  std::sort(arriving.begin(), arriving.end(), [](const layer& a, const layer& b) { return a.where.id < b.where.id; });
  auto kept = alpha_layers<N>::empty();
  for (const layer& l : arriving)
    kept.insert(l.where, l.alpha, l.radiance);
  return kept.resolve(background);
}

}  // namespace pelage::frame
