// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// One pass of depth peeling: each pixel's nearest fragment behind the layer before. [Everitt 2001] In: points, limits,
// slots. Out: slots. One invocation a segment; bounded by the walk and its loads: coverage is computed only where a
// segment may hold the layer.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#define READS_WHILE_OTHERS_WRITE
#define SEEN_BEFORE
#define PASSES_OVER
#include "draw.glsl"
#include "layers.glsl"

/// As a depth test that comes before shading does.
bool passes_over(uint pixel, float least_depth, float most_depth) {
  return pelage_depth_key(most_depth) < uint(slots[last_slot(pixel)] >> 32u) ||
         pelage_depth_key(least_depth) > uint(slots[nearest_slot(pixel)] >> 32u);
}

void visit(uint i, uint pixel, segment_in_pixel where) {
  const uint64_t number = pelage_pack(fragment_of(i, where));
  if (number > slots[last_slot(pixel)] && number < slots[nearest_slot(pixel)]) {
    pelage_atomic_cells_64_fetch_min(nearest_slot(pixel), number, pelage_memory_order_relaxed);
  }
}

void main() {
  draw_segments();
}
