// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The ordered lists' first `push.k` nodes, and the rest of both lists of a pixel to the tail. In: pool, links. One
// invocation a pixel; bounded by dependent loads, one a node.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sink.glsl"
#include "lists.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  sink_begin(at, false);
  uint held = 0u;
  for (uint node = pelage_ordered_list_first(index_of(at)); node != pelage_no_node();
       node = pelage_ordered_list_next(node)) {
    const pelage_fragment f = pelage_atomic_list_storage_read_node(node);
    if (held < push.k) {
      sink_keep(f);
    } else {
      sink_lose(f);
    }
    ++held;
  }
  for (uint node = pelage_a_buffer_first(view_pixels() + index_of(at)); node != pelage_no_node();
       node = pelage_a_buffer_next(node)) {
    sink_lose(pelage_atomic_list_storage_read_node(node));
  }
  sink_finish(at);
}
