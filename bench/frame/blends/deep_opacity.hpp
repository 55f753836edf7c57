// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/order_weighted.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/opacity_map.hpp>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

#include "frame/order/layer.hpp"

namespace pelage::frame {

/// What is seen of a pixel's fragments before a background where a deep opacity map says how much of each passes those
/// before it: equal layers between the pixel's nearest and farthest depth [Yuksel & Keyser 2008, seen from the eye as
/// in Yu12 Fig. 8]. The same bits for every order. As the papers have it a fragment lies in part before itself, by
/// where it lies in its layer (the nearest not at all, the farthest whole), and the sum is taken as it is.
/// `is_corrected`: it is left out of its layer, and the sum is scaled to what the fibres cover: so one fragment alone
/// is exact, and so are fragments of one colour.
template <std::uint32_t Layers>
[[nodiscard]] glm::vec3 blend_deep_opacity(std::span<const layer> fragments, const glm::vec3& background,
                                           bool is_corrected) {
  depth_range range = depth_range::empty();
  for (const layer& f : fragments)
    range.extend(f.where.depth);
  const auto position = [&](const layer& f) { return slice_position(range.relative(f.where.depth), Layers); };
  opacity_map<Layers> map = opacity_map<Layers>::empty();
  for (const layer& f : fragments)
    map.add(position(f), optical_depth(f.alpha));
  map.accumulate();
  tail sum = empty_tail();
  for (const layer& f : fragments) {
    const float before = map.accumulated_before_fragment(position(f), is_corrected ? optical_depth(f.alpha) : 0U);
    sum = add_weighted(sum, f.alpha, optical_weight(f.alpha, before), f.radiance);
  }
  return is_corrected ? resolve(sum, background) : resolve_unscaled(sum, background);
}

}  // namespace pelage::frame
