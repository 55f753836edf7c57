// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The atomic K-buffer: each fragment down its pixel's cascade of 64-bit minima, what falls out to the pixel's list. In:
// points, limits. Out: slots, pool, links, seen. One invocation a segment; bounded by up to K atomic minima a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#define READS_WHILE_OTHERS_WRITE
#include "draw.glsl"
#include "lists.glsl"
#include "slots.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  const pelage_fragment lost = pelage_cascade_k_buffer_insert(pixel, fragment_of(i, where));
  if (pelage_is_fragment(lost)) {
    pelage_a_buffer_push(pixel, lost);
  }
}

void main() {
  draw_segments();
}
