// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The fragments of one depth slice, behind those of the slices before: by their segments' numbers, whatever their
// depths. [Svoboda §1.3.3] In: pool, links, shaded, edges. Out: fronts, and links empty for the next slice. One
// invocation a pixel; bounded by the link that every pixel reads, and by the square of a list's length.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "camera_sink.glsl"
#include "fronts.glsl"
#include "lists.glsl"

/// The fragment of the list's smallest number that is `least` at least.
pelage_fragment first_from(uint pixel, uint least) {
  pelage_fragment found = pelage_no_fragment();
  for (uint node = pelage_a_buffer_first(pixel); node != pelage_no_node(); node = pelage_a_buffer_next(node)) {
    const pelage_fragment f = pelage_atomic_list_storage_read_node(node);
    if (f.id >= least && f.id <= found.id) {
      found = f;
    }
  }
  return found;
}

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = index_of(at);
  if (pelage_a_buffer_first(pixel) == pelage_no_node()) {
    return;
  }
  sink_begin(at, false);
  sink_pixel = load_fronts(pixel);
  pelage_fragment f = first_from(pixel, 0u);
  while (pelage_is_fragment(f)) {
    sink_keep(f);
    f = first_from(pixel, f.id + 1u);
  }
  store_fronts(pixel, sink_pixel);
  links[pixel] = pelage_no_node();
}
