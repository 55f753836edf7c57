// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Adds up each texel's coverage. In: points, limits. Out: covered. One invocation a segment; bounded by coverage's
// arithmetic and an add a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define SEEN_BEFORE
#include "draw.glsl"
#include "covered.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  add_covered(VIEW.first_pixel + pixel, pelage_to_fixed(where.coverage));
}

void main() {
  draw_segments();
}
