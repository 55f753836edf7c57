// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What is seen of a pixel's nearest fibres so far, before an edge and beside it, where later passes add those behind.
// 32 bytes.
#ifndef PELAGE_FRAME_FRONTS_GLSL
#define PELAGE_FRAME_FRONTS_GLSL
#include "pelage/glsl/composite/divided_pixel.glsl"
#include "scene.glsl"

layout(std430, binding = 21) buffer front_buffer { vec4 fronts[]; };  ///< two a pixel: radiance and transmittance

pelage_divided_pixel load_fronts(uint pixel) {
  const vec4 near = fronts[2u * pixel];
  const vec4 far = fronts[2u * pixel + 1u];
  return pelage_divided_pixel(pelage_pixel_radiance(near.rgb, vec3(near.a)), pelage_pixel_radiance(far.rgb, vec3(far.a)));
}

void store_fronts(uint pixel, pelage_divided_pixel seen) {
  fronts[2u * pixel] = vec4(seen.near_part.radiance, seen.near_part.transmittance.r);
  fronts[2u * pixel + 1u] = vec4(seen.far_part.radiance, seen.far_part.transmittance.r);
}

#endif
