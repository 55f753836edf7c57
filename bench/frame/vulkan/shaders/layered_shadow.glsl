// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What a light's opacity maps let through, as bench/frame/shadows/layered_shadow.hpp has it.
#ifndef PELAGE_FRAME_LAYERED_SHADOW_GLSL
#define PELAGE_FRAME_LAYERED_SHADOW_GLSL
#include "layer_map.glsl"
#include "pelage/glsl/composite/optical_depth.glsl"

uint layered_light;  ///< whose map is looked up

void look_up_light(uint l) {
  layered_light = l;
}

/// All fibres lie before what opaque objects hide.
float transmittance_at(uint texel, float depth, bool among_fibres) {
  const bool hidden = depth > limits[texel];
  if (hidden && !among_fibres) {
    return 0.0;
  }
  return pelage_transmittance_of(amount_before(layered_light, texel, hidden ? 3.40282347e38 : depth, 0u));
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
    optical[t] = amount_before(layered_light, texels[t], depth[t], 0u);
    whole[t] = amount_before(layered_light, texels[t], 3.40282347e38, 0u);
  }
}

#endif
