// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The second pass of the split K-buffer: each fragment's id to the slot of its depth, what falls out to the pixel's list.
// In: points, limits, slots. Out: slots, pool, links, seen. One invocation a segment; bounded by K loads a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define READS_WHILE_OTHERS_WRITE
#include "draw.glsl"
#include "lists.glsl"
#define SPLIT
#include "slots.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  const pelage_fragment lost = pelage_split_k_buffer_insert(pixel, fragment_of(i, where));
  if (pelage_is_fragment(lost)) {
    pelage_a_buffer_push(pixel, lost);
  }
}

void main() {
  draw_segments();
}
