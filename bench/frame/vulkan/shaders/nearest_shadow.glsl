// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What a light's maps of the K nearest fragments let through, as bench/frame/shadows/k_buffer_shadow.hpp has it.
#ifndef PELAGE_FRAME_NEAREST_SHADOW_GLSL
#define PELAGE_FRAME_NEAREST_SHADOW_GLSL
#include "pelage/glsl/composite/optical_depth.glsl"
#include "scene.glsl"

float entry_depth(uint i) {
  return uintBitsToFloat(entries[i].x);
}

/// What the texel lets through whose `before` first entries lie before a depth.
float transmittance_behind(uvec4 texel, uint before, float depth) {
  const uvec2 last = before > 0u ? entries[texel.x + before - 1u] : uvec2(0u);
  uint optical = last.y;
  if (before == texel.y && texel.z > 0u) {
    // Between the last entry and the farthest fragment the rest's optical depth grows linearly.
    const float from = uintBitsToFloat(last.x);
    const float span = uintBitsToFloat(texel.w) - from;
    const float share = span > 0.0 ? pelage_saturate((depth - from) / span) : 1.0;
    const float greatest = 4294967040.0;  // the last float below 2^32
    optical = pelage_add_saturating(optical, uint(share * min(float(texel.z), greatest)));
  }
  return pelage_transmittance_of(optical);
}

/// What a square of four texels lets through, by rows. All four are searched at once: a search waits for each of its
/// loads, and so four wait together.
vec4 transmittance_in(uint pixel, uint below, float depth) {
  const uvec4 place = uvec4(pixel, pixel + 1u, below, below + 1u);
  uvec4 texel[4];
  uvec4 before = uvec4(0u);
  uint most = 0u;
  for (int t = 0; t < 4; ++t) {
    texel[t] = texels[place[t]];
    most = max(most, texel[t].y);
  }
  for (uint stride = most > 0u ? 1u << uint(findMSB(most)) : 0u; stride > 0u; stride /= 2u) {
    float probe[4];
    for (int t = 0; t < 4; ++t) {
      probe[t] = before[t] + stride <= texel[t].y ? entry_depth(texel[t].x + before[t] + stride - 1u) : depth;
    }
    for (int t = 0; t < 4; ++t) {
      before[t] += probe[t] < depth ? stride : 0u;
    }
  }
  vec4 passed;
  for (int t = 0; t < 4; ++t) {
    passed[t] = depth > limits[place[t]] ? 0.0 : transmittance_behind(texel[t], before[t], depth);
  }
  return passed;
}

#endif
