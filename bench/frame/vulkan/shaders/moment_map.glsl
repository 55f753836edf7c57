// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The moments of a pixel of a view, MOMENTS powers or (TRIGONOMETRIC) angles, and the depth range that they are taken
// over, in the cells of an occupancy map: the range where that has it, so that the same shader finds it, and before it
// the ends of the sums of sums.glsl. All 0 at first.
#ifndef PELAGE_FRAME_MOMENT_MAP_GLSL
#define PELAGE_FRAME_MOMENT_MAP_GLSL
#include "scene.glsl"

layout(std430, binding = 20) LIVE buffer cell_buffer { uint cells[]; };

uint first_cell;  ///< of what the library's functions are about
#define PELAGE_ATOMIC_CELLS_WORDS(i) cells[first_cell + (i)]
#include "pelage/glsl/visibility/depth_range.glsl"
#ifdef TRIGONOMETRIC
#define PELAGE_TRIGONOMETRIC_MOMENTS_N MOMENTS
#include "pelage/glsl/composite/trigonometric_moments.glsl"
#else
#define PELAGE_POWER_MOMENTS_N MOMENTS
#include "pelage/glsl/composite/power_moments.glsl"
#endif

const uint texel_cells = 12u;
const uint ends_cell = 8u;
const uint range_cell = 9u;

// `texel`: among those of all views.

void extend_range(uint texel, float depth) {
  first_cell = texel_cells * texel + range_cell;
  pelage_atomic_depth_range_extend(0u, depth);
}

pelage_depth_range load_range(uint texel) {
  first_cell = texel_cells * texel + range_cell;
  return pelage_atomic_depth_range_load(0u);
}

/// Where a depth lies in a texel's range, [0, 1].
float map_position(pelage_depth_range range, float depth) {
  return pelage_depth_range_relative(range, depth);
}

/// Puts a fragment in.
void occupy(uint texel, float position, uint amount) {
  first_cell = texel_cells * texel;
#ifdef TRIGONOMETRIC
  pelage_atomic_trigonometric_moments_add(0u, pelage_trigonometric_moments_of(position, amount));
#else
  pelage_atomic_power_moments_add(0u, pelage_power_moments_of(position, amount));
#endif
}

/// What lies before a fragment that is in the moments of a texel, itself left out.
float amount_before_fragment(uint texel, float depth, uint own) {
  const float position = map_position(load_range(texel), depth);
  first_cell = texel_cells * texel;
#ifdef TRIGONOMETRIC
  const pelage_trigonometric_moments moments = pelage_atomic_trigonometric_moments_load(0u);
  return pelage_trigonometric_visibility_amount_before_fragment(pelage_trigonometric_moments_visibility(moments),
                                                                position, own);
#else
  const pelage_power_moments moments = pelage_atomic_power_moments_load(0u);
  return pelage_power_visibility_amount_before_fragment(pelage_power_moments_visibility(moments), position, own);
#endif
}

// What sums.glsl keeps with the map.

void mark_end(uint texel, uint i) {
  atomicOr(cells[texel_cells * texel + ends_cell], 1u << i);
}

uint passed_ends(uint texel) {
  return cells[texel_cells * texel + ends_cell];
}

uint total_of(uint texel) {
  first_cell = texel_cells * texel;
#ifdef TRIGONOMETRIC
  return pelage_atomic_trigonometric_moments_load(0u).sum[0];
#else
  return pelage_atomic_power_moments_load(0u).sum[0];
#endif
}

#endif
