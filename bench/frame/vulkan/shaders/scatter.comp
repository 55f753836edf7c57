// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Puts each fragment into its pixel's run. In: runs, the first free places in counts. Out: pool, or with RECORDS the
// fragments and what they cover to records; seen. One invocation a segment; bounded by the arithmetic of coverage, then
// by one atomic add and 8 or 16 bytes to a place of its own a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define PELAGE_FRAME_DRAWS
#include "raster.glsl"

void visit(uint i, uint pixel, touch where) {
  const uint place = atomicAdd(counts[pixel], 1u);
  if (place >= runs[pixel].y) {
    atomicAdd(reports[push.view].refused, 1u);
    return;
  }
#ifdef RECORDS
  records[place] = uvec4(floatBitsToUint(where.depth), i, floatBitsToUint(where.coverage), floatBitsToUint(where.along));
#else
  pool[place] = fragment_of(i, where);
#endif
}

void main() {
  draw_own_segment();
}
