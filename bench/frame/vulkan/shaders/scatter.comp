// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Puts each fragment into its pixel's run. In: runs, the first free places in counts. Out: pool, seen. One invocation
// a segment; bounded by the arithmetic of coverage, then by one atomic add and 8 bytes to a place of its own a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define PELAGE_FRAME_DRAWS
#include "raster.glsl"

void visit(uint segment, ivec2 at, touch where) {
  const uint pixel = index_of(at);
  const uint place = atomicAdd(counts[pixel], 1u);
  if (place < runs[pixel].y) {
    pool[place] = fragment_of(segment, where);
  }
}

void main() {
  draw_own_segment();
}
