// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What a light's occupancy maps let through, as bench/frame/shadows/occupancy_shadow.hpp has it.
#ifndef PELAGE_FRAME_OCCUPANCY_SHADOW_GLSL
#define PELAGE_FRAME_OCCUPANCY_SHADOW_GLSL
#include "occupancy.glsl"
#include "pelage/glsl/composite/optical_depth.glsl"

float transmittance_at(uint texel, float depth, bool among_fibres) {
  if (!among_fibres && depth > limits[texel]) {
    return 0.0;
  }
  const occupancy o = load_occupancy(texel);
  const float before = pelage_occupancy_map_amount_before(o.map, map_position(o.range, depth));
  return pelage_transmittance_of(before);
}

/// Of a square of four texels, by rows, each up to its depth.
vec4 transmittance_in(uint pixel, uint below, vec4 depth, bool among_fibres) {
  return vec4(transmittance_at(pixel, depth.x, among_fibres), transmittance_at(pixel + 1u, depth.y, among_fibres),
              transmittance_at(below, depth.z, among_fibres), transmittance_at(below + 1u, depth.w, among_fibres));
}

/// The optical depth of a square's fibres, each texel's up to its depth, and of all of them.
void optical_in(uint pixel, uint below, vec4 depth, out vec4 optical, out vec4 whole) {
  const uvec4 texels = uvec4(pixel, pixel + 1u, below, below + 1u);
  for (int t = 0; t < 4; ++t) {
    const occupancy o = load_occupancy(texels[t]);
    optical[t] = pelage_occupancy_map_amount_before(o.map, map_position(o.range, depth[t]));
    whole[t] = float(pelage_occupancy_map_total(o.map));
  }
}

#endif
