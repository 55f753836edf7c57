// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Counts for each pixel the fragments that it can have at most, by the screen alone. In: points, limits. Out: counts. One
// invocation a segment; bounded by one atomic add a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "walk.glsl"

void main() {
  const uint number = invocation();
  if (number >= scene.segment_count) {
    return;
  }
  const uint word = segments[number];
  pixel_walk w = walk_of(word, place(word & point_mask));
  ivec2 at;
  while (next_pixel(w, at)) {
    atomicAdd(counts[index_of(at)], 1u);
  }
}
