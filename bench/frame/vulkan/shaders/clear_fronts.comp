// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Before the first slice. Out: fronts. One invocation a pixel; bounded by 32 bytes written a pixel.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "fronts.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (is_inside(at)) {
    store_fronts(index_of(at), pelage_empty_divided_pixel());
  }
}
