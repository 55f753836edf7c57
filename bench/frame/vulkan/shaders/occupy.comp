// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Each fragment's slice and its optical depth to its pixel's occupancy map, or to its opacity map (LAYERED) or its
// moments (MOMENTS). In: points, limits, shaded, the ranges in cells or layers. Out: cells or layers. One invocation a
// segment; bounded by coverage's arithmetic and an add a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define SEEN_BEFORE
#include "draw.glsl"
#include "pixel_map.glsl"
#ifdef FOR_CAMERA
#include "camera_sink.glsl"
#endif

void visit(uint i, uint pixel, segment_in_pixel where) {
  const uint texel = VIEW.first_pixel + pixel;
#ifdef FOR_CAMERA
  sink_go_to(pixel);
  const seen_fibre fibre = see(i, where);
  const float position = map_position(load_range(texel), where.depth);
  occupy(texel, position, pelage_optical_depth(fibre.opacity * fibre.coverage));
#else
  occupy(texel, map_position(load_range(texel), where.depth), fragment_of(i, where).id);
#endif
}

void main() {
  draw_segments();
}
