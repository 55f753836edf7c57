// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The weighted sums of the camera's pixels, before an object's edge and behind it: weight, and weight times radiance,
// in the units of a tail. Its optical depth is what the pixel's occupancy map holds; what of that lies behind the edge
// is summed as well. Not pelage_atomic_tail: 36 bytes a pixel in place of 48, the ends of the sums marked in the map's
// last cell behind those of its own, and all adds on their way before the first answer is waited for.
#ifndef PELAGE_FRAME_SUMS_GLSL
#define PELAGE_FRAME_SUMS_GLSL
#include "occupancy.glsl"
#include "pelage/glsl/composite/divided_pixel.glsl"
#include "pelage/glsl/composite/weighted_sum.glsl"

layout(std430, binding = 21) buffer sum_buffer { uint sums[]; };

const uint optical_behind = 8u;  ///< the last of a pixel's sums; four before the edge and four behind it come first

/// The four before the edge lie together, of all pixels; what lies behind an edge is rare.
uint place_of_sum(uint pixel, uint i) {
  return i < 4u ? 4u * pixel + i : 4u * uint(VIEW.size.x * VIEW.size.y) + 5u * pixel + (i - 4u);
}

uint ends_cell(uint texel) {
  return texel_cells * texel + pelage_occupancy_map_cells - 1u;
}

void mark_end(uint texel, uint i) {
  atomicOr(cells[ends_cell(texel)], 1u << (PELAGE_OCCUPANCY_MAP_SLABS + i));
}

/// What lies deep adds nothing.
void add_to_sums(uint pixel, uint texel, bool is_before_edge, pelage_tail one) {
  const uvec4 part = uvec4(one.weight, one.red, one.green, one.blue);
  const uint first = is_before_edge ? 0u : 4u;
  if (!is_before_edge && atomicAdd(sums[place_of_sum(pixel, optical_behind)], one.optical) > 0xffffffffu - one.optical) {
    mark_end(texel, optical_behind);
  }
  if (part == uvec4(0u)) {
    return;
  }
  uvec4 held;
  for (uint i = 0u; i < 4u; ++i) {
    held[i] = atomicAdd(sums[place_of_sum(pixel, first + i)], part[i]);
  }
  const bvec4 passes = greaterThan(held, 0xffffffffu - part);
  if (any(passes)) {
    for (uint i = 0u; i < 4u; ++i) {
      if (passes[i]) {
        mark_end(texel, first + i);
      }
    }
  }
}

uint load_sum(uint pixel, uint passed, uint i) {
  return (passed >> i & 1u) != 0u ? 0xffffffffu : sums[place_of_sum(pixel, i)];
}

/// The sums before the edge and behind it as tails, of which the pixel is seen.
pelage_divided_pixel load_sums(uint pixel, uint texel) {
  const uint passed = cells[ends_cell(texel)] >> PELAGE_OCCUPANCY_MAP_SLABS;
  uint sum[9];
  for (uint i = 0u; i < 9u; ++i) {
    sum[i] = load_sum(pixel, passed, i);
  }
  const uint total = pelage_occupancy_map_total(load_occupancy(texel).map);
  const uint behind = min(sum[optical_behind], total);
  return pelage_add_tails(pelage_empty_divided_pixel(), pelage_tail(total - behind, sum[0], sum[1], sum[2], sum[3]),
                          pelage_tail(behind, sum[4], sum[5], sum[6], sum[7]));
}

#endif
