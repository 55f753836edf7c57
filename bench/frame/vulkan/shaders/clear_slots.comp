// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Empties the 64-bit slots. Out: slots. One invocation a pixel; bounded by 8 K bytes written a pixel.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "slots.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  for (uint i = 0u; i < uint(K); ++i) {
    slots[index_of(at) * uint(K) + i] = pelage_pack(pelage_no_fragment());
  }
}
