// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What depth peeling keeps of a pixel: the layer that was taken last, the nearest fragment behind it so far, and what
// is seen of the layers up to the last, before an edge and beside it. 48 bytes.
#ifndef PELAGE_FRAME_LAYERS_GLSL
#define PELAGE_FRAME_LAYERS_GLSL
#include "pelage/glsl/composite/divided_pixel.glsl"
#include "scene.glsl"

layout(std430, binding = 19) LIVE buffer slot_buffer { uint64_t slots[]; };  ///< two a pixel: last, nearest
#define PELAGE_ATOMIC_CELLS_64_WORDS(i) slots[i]
#include "pelage/glsl/core/atomic_cells_64.glsl"
#include "pelage/glsl/order/packed_fragment.glsl"

layout(std430, binding = 21) buffer front_buffer { vec4 fronts[]; };  ///< two a pixel: radiance and transmittance

uint last_slot(uint pixel) {
  return 2u * pixel;
}

uint nearest_slot(uint pixel) {
  return 2u * pixel + 1u;
}

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
