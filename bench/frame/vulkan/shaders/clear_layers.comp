// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Before the first layer. Out: slots, fronts. One invocation a pixel; bounded by 48 bytes written a pixel.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "layers.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (is_inside(at)) {
    const uint pixel = index_of(at);
    slots[last_slot(pixel)] = 0ul;  // before every fragment
    slots[nearest_slot(pixel)] = pelage_pack(pelage_no_fragment());
    store_fronts(pixel, pelage_empty_divided_pixel());
  }
}
