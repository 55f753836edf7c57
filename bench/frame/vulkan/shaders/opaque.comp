// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// How far each pixel of a view sees: the depth of the opaque objects, of the camera's pixels by samples, which part at
// the depth that stands in the place of an edge until background.comp has it. In: the scene. Out: limits, edges,
// block_limits. One invocation a pixel; bounded by the ellipsoids' arithmetic.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "edge.glsl"
#include "solids.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  const uint side = is_camera() && scene.antialias ? 3u : 1u;
  float nearest = uintBitsToFloat(0x7f800000u);
  float farthest = 0.0;
  for (uint i = 0u; i < side * side; ++i) {
    const float depth = opaque_depth(sample_position(at, i, side));
    nearest = min(nearest, depth);
    farthest = max(farthest, depth);
  }
  if (is_camera()) {
    edges[first_of_edge(index_of(at))] = pelage_parting_depth(nearest, farthest);
  }
  limits[VIEW.first_pixel + index_of(at)] = farthest;
  const uint farthest_near = subgroupMax(floatBitsToUint(farthest));  // a subgroup lies in one block
  if (subgroupElect()) {
    atomicMax(block_limits[VIEW.first_block + block_index(at / block_side)], farthest_near);
  }
}
