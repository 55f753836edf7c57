// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Counts each pixel's fragments, for the report and for the number of layers; not part of a frame. In: points, limits.
// Out: counts. One invocation a segment; bounded by coverage's arithmetic.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "draw.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  atomicAdd(counts[VIEW.first_pixel + pixel], 1u);
}

void main() {
  draw_segments();
}
