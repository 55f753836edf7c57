// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The K nearest of each pixel's run by select-and-replace, in registers, and what becomes of them and of the rest.
// In: runs, counts, pool. Out: what the sink writes. One invocation a pixel; bounded by the buffer's compares, K a
// fragment that enters, in every lane of a subgroup where one enters.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sink.glsl"
#define PELAGE_K_BUFFER_K K
#include "pelage/glsl/order/k_buffer.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = index_of(at);
  const uint end = min(counts[pixel], runs[pixel].y);
  sink_begin(at, false);
  pelage_k_buffer nearest = pelage_k_buffer_empty();
  for (uint i = runs[pixel].x; i < end; ++i) {
    const pelage_fragment lost = pelage_k_buffer_insert(nearest, pool[i]);
    if (pelage_is_fragment(lost)) {
      sink_lose(lost);
    }
  }
  pelage_k_buffer_sort(nearest);
  for (uint i = 0u; i < K; ++i) {
    if (pelage_is_fragment(nearest.slot[i])) {
      sink_keep(nearest.slot[i]);
    }
  }
  sink_finish(at);
}
