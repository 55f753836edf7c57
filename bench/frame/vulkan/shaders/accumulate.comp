// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Makes each layer's sum that of its layer and all before it. In, out: layers. One invocation a pixel; bounded by 8 bytes
// a layer read and written.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "layer_map.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (is_inside(at)) {
    accumulate(VIEW.first_pixel + index_of(at));
  }
}
