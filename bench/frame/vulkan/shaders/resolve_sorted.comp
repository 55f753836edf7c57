// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Each pixel's run sorted by selection where it lies: all of it [Yang10], or with PARTIAL its K first, the rest lost. In:
// runs, counts, pool. Out: what the sink writes. One invocation a pixel; bounded by n² / 2 loads for a pixel of n
// fragments, or K n.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sink.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = VIEW.first_pixel + index_of(at);
  const uint begin = runs[pixel].x;
  const uint end = min(counts[pixel], runs[pixel].y);
#ifdef PARTIAL
  const bool whole = false;
  const uint sorted = begin + min(end - begin, push.k);
#else
  const bool whole = true;
  const uint sorted = end;
#endif
  sink_begin(at, whole);
  for (uint i = begin; i < sorted; ++i) {
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
  for (uint i = sorted; i < end; ++i) {
    sink_lose(pool[i]);
  }
  sink_finish(at);
}
