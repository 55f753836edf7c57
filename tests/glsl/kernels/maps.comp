// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
// Every map that many invocations build at once, one after another in one buffer of cells. LOAD: reads them instead.
#include "pelage/glsl/core/fragment.glsl"
#include "pelage/glsl/composite/tail.glsl"

layout(local_size_x_id = 0) in;
layout(std430, binding = 0) readonly buffer offers {
  uint unused;
  uint texels;
  pelage_fragment offered[];
};
layout(std430, binding = 1) coherent buffer cell_block {
  uint found[];
};
#ifdef LOAD
layout(std430, binding = 2) buffer loaded_block {
  uint loaded[];
};
#endif

uint base = 0u;
#define PELAGE_ATOMIC_CELLS_WORDS(i) found[base + i]
#include "pelage/glsl/composite/atomic_tail.glsl"
#include "pelage/glsl/composite/stochastic.glsl"
#include "pelage/glsl/visibility/density_clusters.glsl"
#include "pelage/glsl/visibility/depth_range.glsl"
#include "pelage/glsl/visibility/occupancy_map.glsl"
#include "pelage/glsl/visibility/opacity_map.glsl"

#ifdef LOAD
uint next;
void give(uint value) { loaded[next++] = value; }
void give(pelage_tail tail) {
  give(tail.optical);
  give(tail.weight);
  give(tail.red);
  give(tail.green);
  give(tail.blue);
}

void use(uint texel) {
  if (texel >= texels) return;
  next = texel * (2u + pelage_occupancy_map_cells - 1u + 16u + pelage_density_clusters_cells + 16u + 5u + 40u);
  const pelage_depth_range range = pelage_atomic_depth_range_load(texel);
  give(range.nearest);
  give(range.farthest);
  base += 2u * texels;
  const pelage_occupancy_map occupancy = pelage_atomic_occupancy_map_load(texel);
  for (uint i = 0u; i < 4u; ++i) give(occupancy.occupied[i]);
  for (uint i = 0u; i < 4u; ++i) give(occupancy.amount[i]);
  base += pelage_occupancy_map_cells * texels;
  const pelage_opacity_map opacity = pelage_atomic_opacity_map_load(texel);
  for (uint i = 0u; i < 16u; ++i) give(opacity.amount[i]);
  base += 16u * texels;
  const pelage_density_clusters clusters = pelage_atomic_density_clusters_load(texel);
  for (uint i = 0u; i < 4u; ++i) give(clusters.count[i]);
  for (uint i = 0u; i < 4u; ++i) give(clusters.sum[i]);
  for (uint i = 0u; i < 4u; ++i) give(clusters.squares[i]);
  base += pelage_density_clusters_cells * texels;
  const pelage_stochastic_depths depths = pelage_atomic_stochastic_depths_load(texel);
  for (uint i = 0u; i < 16u; ++i) give(depths.nearest[i]);
  base += 16u * texels;
  give(pelage_atomic_tail_load(texel));
  base += 6u * texels;
  const uint first = texel * pelage_layer_sums_texel_cells(40u);
  pelage_layer_sums_accumulate(first, 40u);
  for (uint i = 0u; i < 40u; ++i) give(floatBitsToUint(pelage_layer_sums_accumulated_before(first, 40u, float(i), 0u)));
}
#else
void use(uint i) {
  const uint texel = i % texels;
  const pelage_fragment f = offered[i];
  const float share = float(f.id >> 8u) * (1.0 / 16777216.0);
  const pelage_tail one = pelage_tail(f.id, f.id >> 4u, f.id >> 8u, f.id >> 12u, f.id & 1u);
  pelage_atomic_depth_range_extend(texel, f.depth);
  base += 2u * texels;
  pelage_atomic_occupancy_map_add(texel, share * 128.0, f.id);
  base += pelage_occupancy_map_cells * texels;
  pelage_atomic_opacity_map_add(texel, share * 16.0, f.id);
  base += 16u * texels;
  pelage_atomic_density_clusters_add(texel, share * 4.0);
  base += pelage_density_clusters_cells * texels;
  pelage_atomic_stochastic_depths_add(texel, f, share, 7u);
  base += 16u * texels;
  pelage_atomic_tail_add(texel, one);
  base += 6u * texels;
  pelage_layer_sums_add(texel * pelage_layer_sums_texel_cells(40u), 40u, share * 40.0, f.id);
}
#endif

void main() {
  if (gl_GlobalInvocationID.x < uint(offered.length())) use(gl_GlobalInvocationID.x);
}
