// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Adds each fragment to its pixel's sums: as it is and counted (AVERAGE) [Bavoil & Myers 2008], weighted by its depth in
// the pixel's range (BY_DEPTH) [McGuire & Bavoil 2013], or by what the pixel's map holds before it: an occupancy map
// [Sintorn & Assarsson 2009, §3.4], layers [Yu12 Fig. 8] or moments [Münstermann et al. 2018]. In: points, limits, edges,
// shaded, the map. Out: sums. One invocation a segment; bounded by coverage's arithmetic and by four or five adds a
// fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define SEEN_BEFORE
#include "draw.glsl"
#include "camera_sink.glsl"
#include "pelage/glsl/composite/order_weighted.glsl"
#include "pelage/glsl/composite/weighted_blended.glsl"
#include "sums.glsl"

/// The optical depth stands in the place of the count where that is not asked for.
void visit(uint i, uint pixel, segment_in_pixel where) {
  sink_go_to(pixel);
  const seen_fibre fibre = see(i, where);
  const float alpha = fibre.opacity * fibre.coverage;
  const uint texel = VIEW.first_pixel + pixel;
#if defined(AVERAGE)
  pelage_tail one = pelage_add_fragment(pelage_empty_tail(), alpha, fibre.radiance);
  one.optical = 1u;
  occupy(texel, 0.0, one.optical);
#elif defined(BY_DEPTH)
  const float weight = pelage_depth_weight(alpha, pelage_depth_range_relative(load_range(texel), where.depth));
  const pelage_tail one = pelage_add_weighted(pelage_empty_tail(), alpha, weight, fibre.radiance);
  occupy(texel, 0.0, one.optical);
#else
  const float before = amount_before_fragment(texel, where.depth, pelage_optical_depth(alpha));
  const float weight = pelage_optical_weight(alpha, before);
  const pelage_tail one = pelage_add_weighted(pelage_empty_tail(), alpha, weight, fibre.radiance);
#endif
  add_to_sums(pixel, texel, fibre.is_before_edge, one);
}

void main() {
  draw_segments();
}
