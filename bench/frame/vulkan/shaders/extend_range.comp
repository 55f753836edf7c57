// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The depth range of each pixel's fragments. In: points, limits. Out: cells or (LAYERED) layers, seen. One invocation a segment; bounded by
// coverage's arithmetic.
#version 450
#extension GL_GOOGLE_include_directive : require
#define READS_WHILE_OTHERS_WRITE
#include "draw.glsl"
#include "pixel_map.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  extend_range(VIEW.first_pixel + pixel, where.depth);
}

void main() {
  draw_segments();
}
