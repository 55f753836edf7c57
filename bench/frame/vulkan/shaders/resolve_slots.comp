// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Each pixel's slots, sorted, and its list of what fell out. In: slots, pool, links. Out: what the sink
// writes. One invocation a pixel; bounded by the list's dependent loads.
#version 450
#extension GL_GOOGLE_include_directive : require
#ifndef SPLIT
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#endif
#include "sink.glsl"
#include "lists.glsl"
#include "slots.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  sink_begin(at, false);
  for (uint i = 0u; i < uint(K); ++i) {
    const pelage_fragment f = slot_at(index_of(at), i);
    if (!pelage_is_fragment(f)) {
      break;
    }
    sink_keep(f);
  }
  for (uint node = pelage_a_buffer_first(index_of(at)); node != pelage_no_node(); node = pelage_a_buffer_next(node)) {
    sink_lose(pelage_atomic_list_storage_read_node(node));
  }
  sink_finish(at);
}
