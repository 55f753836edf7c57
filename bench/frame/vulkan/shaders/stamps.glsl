// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A view's stamps in memory, from the pass that finds them to the one that draws them.
#ifndef PELAGE_FRAME_STAMPS_GLSL
#define PELAGE_FRAME_STAMPS_GLSL
#include "walk.glsl"

layout(std430, binding = 22) buffer stamp_buffer { uvec4 stamps[]; };  ///< the segment's first point, corner, cells

/// Those that there is no room for are only counted: before there is any, and where hair moves.
void put_stamp(uint i, uint point, stamp s) {
  if (i < VIEW.stamp_count) {
    stamps[VIEW.first_stamp + i] = uvec4(point, s.corner, s.cells);
  }
}

/// One without cells for a number from those of this frame on.
stamp stamp_at(uint i, out uint point) {
  const uint put = min(scene.segment_count + reports[this_view()].stamps, VIEW.stamp_count);
  const uvec4 words = i < put ? stamps[VIEW.first_stamp + i] : uvec4(0u);
  point = words.x;
  return stamp(words.y, words.zw);
}

#endif
