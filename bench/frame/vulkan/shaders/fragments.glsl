// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What a segment that touches a pixel leaves there.
#ifndef PELAGE_FRAME_FRAGMENTS_GLSL
#define PELAGE_FRAME_FRAGMENTS_GLSL
#include "raster.glsl"

vec2 drawn_opacity;  ///< at the ends of the segment whose fragment is visited

vec2 opacity_of(uint point) {
  const uint first = VIEW.first_opacity + point;
  return scene.translucent && !is_camera() ? vec2(opacities[first], opacities[first + 1u]) : vec2(1.0);
}

/// Whether the pixel has a part of the segment, not hidden by opaque objects.
bool is_fragment(segment_in_pixel where, uint pixel) {
  return where.coverage > 0.0 && !(where.depth >= limits[VIEW.first_pixel + pixel]);
}

/// What is kept of a fragment in the view: the camera's is found again by its segment's first point, a number that
/// orders as the segment's; a light needs the optical depth alone, and fragments that have depth and optical depth in
/// common are alike.
precise pelage_fragment fragment_of(uint i, segment_in_pixel where) {
  if (is_camera()) {
    return pelage_fragment(where.depth, i);
  }
  const float opacity = drawn_opacity.x + where.along * (drawn_opacity.y - drawn_opacity.x);
  return pelage_fragment(where.depth, pelage_optical_depth(opacity * where.coverage));
}

#endif
