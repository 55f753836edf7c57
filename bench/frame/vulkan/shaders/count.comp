// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Counts for each pixel the fragments that it can have at most, by the screen alone. In: points, limits. Out: counts. One
// invocation a segment; bounded by one atomic add a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define PELAGE_FRAME_DRAWS
#define PELAGE_FRAME_CANDIDATES
#include "raster.glsl"

void visit(uint pixel) {
  atomicAdd(counts[pixel], 1u);
}

void main() {
  draw_own_segment();
}
