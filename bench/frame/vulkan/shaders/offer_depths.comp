// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The two-pass K-buffer's first pass: each fragment's depth down its pixel's cascade of 32-bit minima. In: points,
// limits. Out: slots. One invocation a segment; bounded by up to K atomic minima a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define PELAGE_FRAME_DRAWS
#include "raster.glsl"
#define SPLIT
#include "slots.glsl"

void visit(uint segment, ivec2 at, touch where) {
  pelage_two_pass_k_buffer_offer_depth(index_of(at), fragment_of(segment, where));
}

void main() {
  draw_own_segment();
}
