// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Adds each fragment to its pixel's sums, weighted by what the pixel's occupancy map has before it. [Sintorn &
// Assarsson 2009, §3.4] In: points, limits, edges, shaded, cells. Out: sums. One invocation a segment; bounded by coverage's
// arithmetic and by four adds a fragment.
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
  const occupancy o = load_occupancy(VIEW.first_pixel + pixel);
  const float before = pelage_occupancy_map_interpolated_before_fragment(o.map, map_position(o.range, where.depth));
  const float weight = pelage_optical_weight(alpha, before);
  const pelage_tail one = pelage_add_weighted(pelage_empty_tail(), alpha, weight, fibre.radiance);
  add_to_sums(pixel, VIEW.first_pixel + pixel, fibre.is_before_edge, one);
}

void main() {
  draw_segments();
}
