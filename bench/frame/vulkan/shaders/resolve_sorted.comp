// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Each pixel's whole run sorted by selection where it lies, then all of it in order. [Yang10] In: runs, counts, pool.
// One invocation a pixel; bounded by n² / 2 loads for a pixel of n fragments.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sink.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = VIEW.first_pixel + index_of(at);
  const uint end = min(counts[pixel], runs[pixel].y);
  sink_begin(at, true);
  for (uint i = runs[pixel].x; i < end; ++i) {
    pelage_fragment nearest = pool[i];
    uint from = i;
    for (uint j = i + 1u; j < end; ++j) {
      const pelage_fragment other = pool[j];
      if (pelage_before(other, nearest)) {
        nearest = other;
        from = j;
      }
    }
    pool[from] = pool[i];
    pool[i] = nearest;
    sink_keep(nearest);
  }
  sink_finish(at);
}
