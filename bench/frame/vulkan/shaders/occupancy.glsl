// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The occupancy map of a pixel of a view, as words that many invocations change at once: a sum a slab, a bit a slice,
// the depth range, and a bit for each sum that went beyond 2³². All words of an empty one are 0.
#ifndef PELAGE_FRAME_OCCUPANCY_GLSL
#define PELAGE_FRAME_OCCUPANCY_GLSL
#include "scene.glsl"

layout(std430, binding = 20) LIVE buffer cell_buffer { uint cells[]; };
layout(std430, binding = 20) readonly buffer quad_buffer { uvec4 quads[]; };  ///< the same, to be read by fours

uint first_cell;  ///< of the texel that the functions below are about
#define PELAGE_ATOMIC_CELLS_WORDS(i) cells[first_cell + (i)]
#include "pelage/glsl/visibility/depth_range.glsl"
#include "pelage/glsl/visibility/occupancy_map.glsl"

const uint texel_cells = 12u;
const uint occupied_cell = 4u;  ///< after the slabs'
const uint nearest_cell = 8u;   ///< complement of the key, so that both ends grow
const uint farthest_cell = 9u;
const uint passed_cell = 10u;

/// `texel`: among those of all views.
void go_to_texel(uint texel) {
  first_cell = texel_cells * texel;
}

void extend_range(float depth) {
  if (pelage_is_finite_depth(depth)) {
    const uint key = pelage_depth_key(depth);
    pelage_raise_cell(nearest_cell, ~key);
    pelage_raise_cell(farthest_cell, key);
  }
}

/// Puts a fragment in.
void occupy(float position, uint amount) {
  const uint slice = pelage_layer_at(position, PELAGE_OCCUPANCY_MAP_SLICES);
  const uint slab = slice / pelage_occupancy_map_slab_slices;
  pelage_set_bits(occupied_cell + slice / 32u, 1u << (slice % 32u));
  pelage_add_and_mark(slab, amount, passed_cell, 1u << slab);
}

/// A texel's map and range.
struct occupancy {
  pelage_occupancy_map map;
  pelage_depth_range range;
};

/// Of a map that is complete.
occupancy load_occupancy() {
  const uvec4 amount = quads[first_cell / 4u];
  const uvec4 occupied = quads[first_cell / 4u + 1u];
  const uvec4 rest = quads[first_cell / 4u + 2u];
  occupancy o;
  o.range = pelage_depth_range(~rest.x, rest.y);
  for (uint i = 0u; i < 4u; ++i) {
    o.map.occupied[i] = occupied[i];
    o.map.amount[i] = (rest.z >> i & 1u) != 0u ? 0xffffffffu : amount[i];
  }
  return o;
}

pelage_depth_range load_range() {
  return pelage_depth_range(~cells[first_cell + nearest_cell], cells[first_cell + farthest_cell]);
}

/// Where a depth lies in a light's map.
float light_position(pelage_depth_range range, float depth) {
  return pelage_slice_position(pelage_depth_range_relative(range, depth), PELAGE_OCCUPANCY_MAP_SLICES);
}

/// And in the camera's: where its slice begins, so that a fragment does not lie before itself; the farthest alone lies
/// in the last slice.
float camera_position(pelage_depth_range range, float depth) {
  return floor(pelage_slice_position(pelage_depth_range_relative(range, depth), PELAGE_OCCUPANCY_MAP_SLICES - 1u));
}

#endif
