// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The K nearest of each pixel of the A-buffer by select-and-replace, in registers. In: pool, links. Out: what the sink
// writes. One invocation a pixel; bounded by K compares a fragment that enters, in every lane of a subgroup where one
// does, and by the lists: each step waits for the link that the last one read.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sink.glsl"
#include "lists.glsl"
#define PELAGE_K_BUFFER_K K
#include "pelage/glsl/order/k_buffer.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  sink_begin(at, false);
  pelage_k_buffer nearest = pelage_k_buffer_empty();
  uint node = pelage_a_buffer_first(index_of(at));
  while (node != pelage_no_node()) {
    const pelage_fragment lost = pelage_k_buffer_insert(nearest, pelage_atomic_list_storage_read_node(node));
    if (pelage_is_fragment(lost)) {
      sink_lose(lost);
    }
    node = pelage_a_buffer_next(node);
  }
  pelage_k_buffer_sort(nearest);
  for (uint i = 0u; i < K; ++i) {
    if (pelage_is_fragment(nearest.slot[i])) {
      sink_keep(nearest.slot[i]);
    }
  }
  sink_finish(at);
}
