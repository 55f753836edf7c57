// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The picture from the weighted sums. In: sums, cells, edges, picture. Out: picture. One invocation a pixel; bounded by some
// 120 bytes a pixel.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "edge.glsl"
#include "sums.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = index_of(at);
  const uint p = 3u * pixel;
  const vec3 colour = pelage_resolve(load_sums(pixel, VIEW.first_pixel + pixel), load_backdrop(pixel));
  picture[p] = colour.r;
  picture[p + 1u] = colour.g;
  picture[p + 2u] = colour.b;
}
