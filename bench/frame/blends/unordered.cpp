// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/blends/unordered.hpp"

#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/weighted_average.hpp>
#include <pelage/composite/weighted_blended.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/occupancy_map.hpp>

namespace pelage::frame {
namespace {

depth_range range_of(std::span<const layer> layers) {
  depth_range range = depth_range::empty();
  for (const layer& l : layers)
    range.extend(l.where.depth);
  return range;
}

}  // namespace

glm::vec3 blend_order_weighted(std::span<const layer> layers, const glm::vec3& background) {
  const depth_range range = range_of(layers);
  const auto position = [&](const layer& l) { return slice_position(range.relative(l.where.depth), 128U); };
  occupancy_map<128, 4> map = occupancy_map<128, 4>::empty();
  for (const layer& l : layers)
    map.add(position(l), optical_depth(l.alpha));
  tail sum = empty_tail();
  for (const layer& l : layers)
    sum =
        add_weighted(sum, l.alpha, optical_weight(l.alpha, map.interpolated_before_fragment(position(l))), l.radiance);
  return resolve(sum, background);
}

glm::vec3 blend_weighted_average(std::span<const layer> layers, const glm::vec3& background) {
  weighted_average sum = weighted_average::empty();
  for (const layer& l : layers)
    sum.add(l.alpha, l.radiance);
  return sum.resolve(background);
}

glm::vec3 blend_weighted_blended(std::span<const layer> layers, const glm::vec3& background) {
  const depth_range range = range_of(layers);
  tail sum = empty_tail();
  for (const layer& l : layers)
    sum = add_weighted(sum, l.alpha, depth_weight(l.alpha, range.relative(l.where.depth)), l.radiance);
  return resolve(sum, background);
}

}  // namespace pelage::frame
