// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The weighted sums of the camera's pixels: weight, and weight times radiance, in the units of a tail, whose optical
// depth is what the pixel's occupancy map holds. Not pelage_atomic_tail: 16 bytes a pixel in place of 24, the ends of
// the sums marked in the map's last cell behind those of its own, and all adds on their way before the first answer is
// waited for.
#ifndef PELAGE_FRAME_SUMS_GLSL
#define PELAGE_FRAME_SUMS_GLSL
#include "occupancy.glsl"
#include "pelage/glsl/composite/weighted_sum.glsl"

layout(std430, binding = 21) buffer sum_buffer { uint sums[]; };

uint ends_cell(uint texel) {
  return texel_cells * texel + pelage_occupancy_map_cells - 1u;
}

/// What lies deep adds nothing.
void add_to_sums(uint pixel, uint texel, uvec4 part) {
  if (part == uvec4(0u)) {
    return;
  }
  uvec4 held;
  for (uint i = 0u; i < 4u; ++i) {
    held[i] = atomicAdd(sums[4u * pixel + i], part[i]);
  }
  const bvec4 passes = greaterThan(held, 0xffffffffu - part);
  if (any(passes)) {
    const uvec4 bits = uvec4(passes) << uvec4(0u, 1u, 2u, 3u);
    atomicOr(cells[ends_cell(texel)], (bits.x | bits.y | bits.z | bits.w) << PELAGE_OCCUPANCY_MAP_SLABS);
  }
}

pelage_tail load_sums(uint pixel, uint texel) {
  const uint passed = cells[ends_cell(texel)] >> PELAGE_OCCUPANCY_MAP_SLABS;
  uvec4 held;
  for (uint i = 0u; i < 4u; ++i) {
    held[i] = (passed >> i & 1u) != 0u ? 0xffffffffu : sums[4u * pixel + i];
  }
  return pelage_tail(pelage_occupancy_map_total(load_occupancy(texel).map), held.x, held.y, held.z, held.w);
}

#endif
