// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The A-buffer: each fragment to the head of its pixel's list. In: points, limits. Out: pool, links, seen. One
// invocation a segment; bounded by coverage's arithmetic, then by an add on one word and an exchange a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "draw.glsl"
#include "lists.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  pelage_a_buffer_push(pixel, fragment_of(i, where));
}

void main() {
  draw_segments();
}
