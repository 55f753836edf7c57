// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Adds each fragment to its pixel's sums, weighted by what the pixel's moments tell of what lies before it. [Münstermann
// et al. 2018] In: points, limits, edges, shaded, cells. Out: sums. One invocation a segment; bounded by the
// reconstruction's arithmetic.
#version 450
#extension GL_GOOGLE_include_directive : require
#define SEEN_BEFORE
#include "draw.glsl"
#include "camera_sink.glsl"
#include "pelage/glsl/composite/order_weighted.glsl"
#include "sums.glsl"

void visit(uint i, uint pixel, segment_in_pixel where) {
  sink_go_to(pixel);
  const seen_fibre fibre = see(i, where);
  const float alpha = fibre.opacity * fibre.coverage;
  const uint texel = VIEW.first_pixel + pixel;
  const float before = amount_before_fragment(texel, where.depth, pelage_optical_depth(alpha));
  const float weight = pelage_optical_weight(alpha, before);
  const pelage_tail one = pelage_add_weighted(pelage_empty_tail(), alpha, weight, fibre.radiance);
  add_to_sums(pixel, texel, fibre.is_before_edge, one);
}

void main() {
  draw_segments();
}
