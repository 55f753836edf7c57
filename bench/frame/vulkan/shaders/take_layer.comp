// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The layer that a pass found, behind those before. A pixel without one is hidden from further passes. In: slots,
// shaded, edges. Out: slots, fronts, limits. One invocation a pixel; bounded by the scattered loads of a fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "camera_sink.glsl"
#include "layers.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = index_of(at);
  const uint64_t nearest = slots[nearest_slot(pixel)];
  const pelage_fragment f = pelage_unpack(nearest);
  if (!pelage_is_fragment(f)) {
    limits[VIEW.first_pixel + pixel] = 0.0;
    return;
  }
  sink_begin(at, false);
  sink_pixel = load_fronts(pixel);
  sink_keep(f);
  store_fronts(pixel, sink_pixel);
  slots[last_slot(pixel)] = nearest;
  slots[nearest_slot(pixel)] = pelage_pack(pelage_no_fragment());
}
