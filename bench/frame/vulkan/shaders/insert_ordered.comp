// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The ordered list: each fragment at its place in its pixel's list, those behind `push.k` nearer ones to a second
// list. In: points, limits. Out: pool, links, seen. One invocation a segment; bounded by the walk along the list, one
// dependent load a step.
#version 450
#extension GL_GOOGLE_include_directive : require
#define READS_WHILE_OTHERS_WRITE
#include "draw.glsl"
#include "lists.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  const pelage_fragment back = pelage_ordered_list_insert(pixel, fragment_of(i, where), push.k);
  if (pelage_is_fragment(back)) {
    pelage_a_buffer_push(view_pixels() + pixel, back);
  }
}

void main() {
  draw_segments();
}
