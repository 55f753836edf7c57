// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Counts the fragments of each pixel. In: points, limits. Out: counts. One invocation a segment; bounded by the
// arithmetic of coverage, then by one atomic add a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define PELAGE_FRAME_DRAWS
#include "raster.glsl"

void visit(uint segment, ivec2 at, touch where) {
  atomicAdd(counts[index_of(at)], 1u);
}

void main() {
  draw_own_segment();
}
