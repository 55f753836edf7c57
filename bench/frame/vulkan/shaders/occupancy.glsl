// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The occupancy map of a pixel of a view, as words that many invocations change at once: the depth range, a bit a
// slice, a sum a slab, and a bit for each sum that went beyond 2³². All words of an empty one are 0.
#ifndef PELAGE_FRAME_OCCUPANCY_GLSL
#define PELAGE_FRAME_OCCUPANCY_GLSL
#include "scene.glsl"

layout(std430, binding = 20) LIVE buffer cell_buffer { uint cells[]; };

uint first_cell;  ///< of the texel that the functions below are about
#define PELAGE_ATOMIC_CELL_STORAGE_CELLS(i) cells[first_cell + (i)]
#include "pelage/glsl/visibility/depth_range.glsl"
#include "pelage/glsl/visibility/occupancy_map.glsl"

const uint texel_cells = 12u;
const uint occupied_cell = 2u;  ///< after the range's
const uint amount_cell = occupied_cell + pelage_occupancy_map_words;
const uint passed_cell = amount_cell + PELAGE_OCCUPANCY_MAP_SLABS;

/// `texel`: among those of all views.
void go_to_texel(uint texel) {
  first_cell = texel_cells * texel;
}

/// Both ends grow, the nearest as its complement.
void extend_range(float depth) {
  if (pelage_is_finite_depth(depth)) {
    const uint key = pelage_depth_key(depth);
    if (cells[first_cell] < ~key) {
      atomicMax(cells[first_cell], ~key);
    }
    if (cells[first_cell + 1u] < key) {
      atomicMax(cells[first_cell + 1u], key);
    }
  }
}

/// Where a depth lies in the range, [0, 1].
float relative_depth(float depth) {
  return pelage_depth_range_relative(pelage_depth_range(~cells[first_cell], cells[first_cell + 1u]), depth);
}

/// Puts a fragment in. Hardware adds modulo 2³²; whether a sum passed its end does not depend on the order of adding.
void occupy(float position, uint amount) {
  const uint slice = pelage_layer_at(position, PELAGE_OCCUPANCY_MAP_SLICES);
  const uint slab = slice / pelage_occupancy_map_slab_slices;
  pelage_set_bits(occupied_cell + slice / 32u, 1u << (slice % 32u));
  const uint held = atomicAdd(cells[first_cell + amount_cell + slab], amount);
  if (held > 0xffffffffu - amount) {
    atomicOr(cells[first_cell + passed_cell], 1u << slab);
  }
}

pelage_occupancy_map load_occupancy() {
  pelage_occupancy_map map;
  for (uint i = 0u; i < pelage_occupancy_map_words; ++i) {
    map.occupied[i] = cells[first_cell + occupied_cell + i];
  }
  const uint passed = cells[first_cell + passed_cell];
  for (uint i = 0u; i < PELAGE_OCCUPANCY_MAP_SLABS; ++i) {
    map.amount[i] = (passed >> i & 1u) != 0u ? 0xffffffffu : cells[first_cell + amount_cell + i];
  }
  return map;
}

/// Where a depth lies in a light's map.
float light_position(float depth) {
  return pelage_slice_position(relative_depth(depth), PELAGE_OCCUPANCY_MAP_SLICES);
}

/// And in the camera's: where its slice begins, so that a fragment does not lie before itself; the farthest alone lies
/// in the last slice.
float camera_position(float depth) {
  return floor(pelage_slice_position(relative_depth(depth), PELAGE_OCCUPANCY_MAP_SLICES - 1u));
}

#endif
