// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The weighted sums of the camera's pixels: weight, and weight times radiance, in the units of a tail, whose optical
// depth is what the pixel's occupancy map holds.
#ifndef PELAGE_FRAME_SUMS_GLSL
#define PELAGE_FRAME_SUMS_GLSL
#include "occupancy.glsl"
#include "pelage/glsl/composite/weighted_sum.glsl"

layout(std430, binding = 21) buffer sum_buffer { uint sums[]; };

/// What lies deep adds nothing. All four parts are on their way before the first answer is waited for.
void add_to_sums(uint pixel, uvec4 part) {
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
    atomicOr(cells[first_cell + passed_cell], (bits.x | bits.y | bits.z | bits.w) << PELAGE_OCCUPANCY_MAP_SLABS);
  }
}

pelage_tail load_sums(uint pixel) {
  const uint passed = cells[first_cell + passed_cell] >> PELAGE_OCCUPANCY_MAP_SLABS;
  uvec4 held;
  for (uint i = 0u; i < 4u; ++i) {
    held[i] = (passed >> i & 1u) != 0u ? 0xffffffffu : sums[4u * pixel + i];
  }
  return pelage_tail(pelage_occupancy_map_total(load_occupancy().map), held.x, held.y, held.z, held.w);
}

#endif
