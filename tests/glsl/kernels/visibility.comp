// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
// Maps of one invocation, and an occupancy map of a second size.
#define FRAGMENTS 12u
#define STRIDE (2u * FRAGMENTS + 10u)
#define RESULTS 94u
#include "table.glsl"

// No invocation here writes to a cell that others see: the maps are structs.
#define PELAGE_ATOMIC_CELLS_WORDS(i) results[i]
#include "pelage/glsl/core/mixed_bits.glsl"
#include "pelage/glsl/visibility/density_clusters.glsl"
#include "pelage/glsl/visibility/depth_range.glsl"
#include "pelage/glsl/visibility/layer_position.glsl"
#include "pelage/glsl/visibility/lookup_jitter.glsl"
#include "pelage/glsl/visibility/occupancy_map.glsl"
#include "pelage/glsl/visibility/opacity_map.glsl"
#include "pelage/glsl/visibility/receiver.glsl"

#undef PELAGE_OCCUPANCY_MAP_SLICES
#undef PELAGE_OCCUPANCY_MAP_SLABS
#define PELAGE_OCCUPANCY_MAP_SLICES 96
#define PELAGE_OCCUPANCY_MAP_SLABS 12
#define PELAGE_PREFIX small
#include "pelage/glsl/visibility/occupancy_map.glsl"
#undef PELAGE_PREFIX

uint next = 0u;
void give(uint value) { put(next++, value); }
void give(float value) { put(next++, value); }

void main() {
  if (outside()) return;
  pelage_depth_range range = pelage_depth_range_empty();
  pelage_depth_range behind = pelage_depth_range_empty();
  pelage_occupancy_map occupancy = pelage_occupancy_map_empty();
  pelage_occupancy_map others = pelage_occupancy_map_empty();
  small_occupancy_map few = small_occupancy_map_empty();
  pelage_opacity_map opacity = pelage_opacity_map_empty();
  pelage_opacity_map rest = pelage_opacity_map_empty();
  pelage_density_clusters clusters = pelage_density_clusters_empty();
  for (uint i = 0u; i < FRAGMENTS; ++i) {
    const float relative = f(2u * i);
    const uint added = u(2u * i + 1u);
    if (i % 2u == 0u) {
      pelage_depth_range_extend(range, uintBitsToFloat(added));
      pelage_occupancy_map_add(occupancy, pelage_slice_position(relative, 128u), added);
      pelage_opacity_map_add(opacity, pelage_slice_position(relative, 16u), added);
    } else {
      pelage_depth_range_extend(behind, relative);
      pelage_occupancy_map_add(others, pelage_slice_position(relative, 128u), added);
      pelage_opacity_map_add(rest, pelage_slice_position(relative, 16u), added);
    }
    small_occupancy_map_add(few, pelage_slice_position(relative, 96u), 1u);
    pelage_density_clusters_add(clusters, pelage_slice_position(relative, 4u));
  }
  pelage_depth_range_merge(range, behind);
  pelage_occupancy_map_merge(occupancy, others);
  pelage_opacity_map_merge(opacity, rest);
  const float look = f(2u * FRAGMENTS);
  give(range.nearest);
  give(range.farthest);
  for (uint i = 0u; i < 4u; ++i) give(occupancy.occupied[i]);
  for (uint i = 0u; i < 4u; ++i) give(occupancy.amount[i]);
  give(pelage_occupancy_map_total(occupancy));
  for (uint i = 0u; i < 3u; ++i) give(few.occupied[i]);
  for (uint i = 0u; i < 12u; ++i) give(few.amount[i]);
  for (uint i = 0u; i < 16u; ++i) give(opacity.amount[i]);
  give(pelage_opacity_map_total(opacity));
  for (uint i = 0u; i < 4u; ++i) {
    give(clusters.count[i]);
    give(clusters.sum[i]);
    give(clusters.squares[i]);
  }
  give(pelage_occupancy_map_amount_before(occupancy, pelage_slice_position(look, 128u)));
  give(pelage_occupancy_map_amount_before_fragment(occupancy, pelage_slice_position(look, 128u)));
  give(pelage_occupancy_map_interpolated_before_fragment(occupancy, pelage_slice_position(look, 128u)));
  give(small_occupancy_map_amount_before(few, pelage_slice_position(look, 96u)));
  give(pelage_opacity_map_amount_before(opacity, pelage_slice_position(look, 16u)));
  give(pelage_opacity_map_amount_before_fragment(opacity, pelage_slice_position(look, 16u)));
  pelage_opacity_map_accumulate(opacity);
  for (uint i = 0u; i < 16u; ++i) give(opacity.amount[i]);
  give(pelage_opacity_map_accumulated_before(opacity, pelage_slice_position(look, 16u)));
  give(pelage_opacity_map_accumulated_before_fragment(opacity, pelage_slice_position(look, 16u), u(1u)));
  give(pelage_density_clusters_count_before(clusters, pelage_slice_position(look, 4u)));
  const float offset = f(2u * FRAGMENTS + 1u);
  const float width = f(2u * FRAGMENTS + 2u);
  give(pelage_depth_range_nearest_depth(behind));
  give(pelage_depth_range_farthest_depth(behind));
  give(pelage_depth_range_relative(behind, look));
  give(pelage_equal_layer_position(offset, width, 16u));
  give(pelage_growing_layer_position(offset, width, 16u));
  give(pelage_growing_layer_width(offset, 16u));
  give(pelage_layer_at(pelage_slice_position(look, 7u), 7u));
  give(pelage_mixed_bits(u(2u * FRAGMENTS + 3u)));
  const vec2 jitter = pelage_lookup_jitter(u(2u * FRAGMENTS + 4u));
  give(jitter.x);
  give(jitter.y);
  const vec3 ray = vec3(f(2u * FRAGMENTS + 5u), f(2u * FRAGMENTS + 6u), -1.0);
  const vec2 line = pelage_line_depth_slope(ray, v3(2u * FRAGMENTS + 7u), 64.0);
  give(line.x);
  give(line.y);
  const vec2 plane = pelage_plane_depth_slope(ray, v3(2u * FRAGMENTS + 7u), 64.0);
  give(plane.x);
  give(plane.y);
}
