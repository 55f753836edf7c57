// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A view's stamps in memory, from the pass that finds them to the one that draws them.
#ifndef PELAGE_FRAME_STAMPS_GLSL
#define PELAGE_FRAME_STAMPS_GLSL
#include "walk.glsl"

layout(std430, binding = 22) buffer stamp_buffer { uvec4 stamps[]; };  ///< the segment's first point, corner, cells

/// Before there is room for them the first frame only counts stamps.
void put_stamp(uint i, uint point, stamp s) {
  if (i < VIEW.stamp_count) {
    stamps[VIEW.first_stamp + i] = uvec4(point, s.corner, s.cells);
  }
}

/// One without cells for a number from VIEW.stamp_count on.
stamp stamp_at(uint i, out uint point) {
  const uvec4 words = i < VIEW.stamp_count ? stamps[VIEW.first_stamp + i] : uvec4(0u);
  point = words.x;
  return stamp(words.y, words.zw);
}

#endif
