// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The occupancy map of a pixel of a view and the depth range that it divides, in cells that many invocations change at
// once, all 0 at first.
#ifndef PELAGE_FRAME_OCCUPANCY_GLSL
#define PELAGE_FRAME_OCCUPANCY_GLSL
#include "scene.glsl"

layout(std430, binding = 20) LIVE buffer cell_buffer { uint cells[]; };
layout(std430, binding = 20) readonly buffer quad_buffer { uvec4 quads[]; };  ///< the same, to be read by fours

uint first_cell;  ///< of what the library's functions are about: a texel's map, or its range behind that
#define PELAGE_ATOMIC_CELLS_WORDS(i) cells[first_cell + (i)]
#include "pelage/glsl/visibility/depth_range.glsl"
#include "pelage/glsl/visibility/occupancy_map.glsl"

const uint texel_cells = 12u;

// `texel`: among those of all views.

void extend_range(uint texel, float depth) {
  first_cell = texel_cells * texel + pelage_occupancy_map_cells;
  pelage_atomic_depth_range_extend(0u, depth);
}

pelage_depth_range load_range(uint texel) {
  first_cell = texel_cells * texel + pelage_occupancy_map_cells;
  return pelage_atomic_depth_range_load(0u);
}

/// Puts a fragment in.
void occupy(uint texel, float position, uint amount) {
  first_cell = texel_cells * texel;
  pelage_atomic_occupancy_map_add(0u, position, amount);
}

/// A texel's map and range.
struct occupancy {
  pelage_occupancy_map map;
  pelage_depth_range range;
};

/// As pelage_atomic_occupancy_map_load() and pelage_atomic_depth_range_load() of a map that is complete, in three loads.
occupancy load_occupancy(uint texel) {
  const uint first = texel_cells / 4u * texel;
  const uvec4 occupied = quads[first];
  const uvec4 amount = quads[first + 1u];
  const uvec4 rest = quads[first + 2u];
  occupancy o;
  o.range = pelage_depth_range(~rest.y, rest.z);
  for (uint i = 0u; i < 4u; ++i) {
    o.map.occupied[i] = occupied[i];
    o.map.amount[i] = (rest.x >> i & 1u) != 0u ? 0xffffffffu : amount[i];
  }
  return o;
}

/// Where a depth lies in a texel's map.
float map_position(pelage_depth_range range, float depth) {
  return pelage_slice_position(pelage_depth_range_relative(range, depth), PELAGE_OCCUPANCY_MAP_SLICES);
}

/// What lies before a fragment that is in a texel's map, itself left out: no need to know how much of it is there.
float amount_before_fragment(uint texel, float depth, uint own) {
  const occupancy o = load_occupancy(texel);
  return pelage_occupancy_map_interpolated_before_fragment(o.map, map_position(o.range, depth));
}

// What sums.glsl keeps with the map: which of its nine sums passed their ends, behind those of the slabs.

void mark_end(uint texel, uint i) {
  atomicOr(cells[texel_cells * texel + pelage_occupancy_map_cells - 1u], 1u << (PELAGE_OCCUPANCY_MAP_SLABS + i));
}

uint passed_ends(uint texel) {
  return cells[texel_cells * texel + pelage_occupancy_map_cells - 1u] >> PELAGE_OCCUPANCY_MAP_SLABS;
}

uint total_of(uint texel) {
  return pelage_occupancy_map_total(load_occupancy(texel).map);
}

#endif
