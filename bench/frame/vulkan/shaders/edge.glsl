// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What is opaque in the camera's pixels: two surfaces where an object's edge divides one. See backdrop in
// bench/frame/shading/backdrop.hpp. 20 bytes a pixel beside its mean in the picture.
#ifndef PELAGE_FRAME_EDGE_GLSL
#define PELAGE_FRAME_EDGE_GLSL
#include "pelage/glsl/composite/divided_pixel.glsl"
#include "scene.glsl"

uint first_of_edge(uint pixel) {
  return 5u * pixel;
}

/// The pixel's, while the picture holds what is seen there without fibres.
pelage_divided_backdrop load_backdrop(uint pixel) {
  const uint e = first_of_edge(pixel);
  const uint p = 3u * pixel;
  return pelage_divided_backdrop(edges[e], edges[e + 1u], vec3(edges[e + 2u], edges[e + 3u], edges[e + 4u]),
                                 vec3(picture[p], picture[p + 1u], picture[p + 2u]));
}

#endif
