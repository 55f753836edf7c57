// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The first pass of the split K-buffer: each fragment's depth down its pixel's cascade of 32-bit minima. In: points,
// limits. Out: slots. One invocation a segment; bounded by up to K atomic minima a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define READS_WHILE_OTHERS_WRITE
#include "draw.glsl"
#define SPLIT
#include "slots.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  pelage_split_k_buffer_offer_depth(pixel, fragment_of(i, where));
}

void main() {
  draw_segments();
}
