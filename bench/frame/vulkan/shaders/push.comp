// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The A-buffer: each fragment to the head of its pixel's list. In: points, limits. Out: pool, links, seen. One
// invocation a segment; bounded by coverage's arithmetic, then by an add on one word and an exchange a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define PELAGE_FRAME_DRAWS
#include "raster.glsl"
#include "lists.glsl"

void visit(uint segment, ivec2 at, touch where) {
  pelage_a_buffer_push(index_of(at), fragment_of(segment, where));
}

void main() {
  draw_own_segment();
}
