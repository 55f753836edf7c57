// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A texel of a light's map: its entries, and beside them what most lookups end with, in 32 bytes that lie together.
#ifndef PELAGE_FRAME_TEXEL_GLSL
#define PELAGE_FRAME_TEXEL_GLSL
#include "scene.glsl"

struct texel {
  uint first;     ///< of its entries, by depth
  uint held;      ///< entries
  uint behind;    ///< optical depth of the fragments that have none
  float farthest;  ///< of those
  float last_depth;  ///< the last entry
  uint last_optical;
  float limit;  ///< opaque objects stand there
  float mean;   ///< of the depths of the fragments that have none, weighted by optical depth
};

layout(std430, binding = 12) buffer texel_buffer { uvec4 texels[]; };  ///< two a pixel of a light

texel texel_in(uint pixel) {
  const uvec4 a = texels[2u * pixel];
  const uvec4 b = texels[2u * pixel + 1u];
  return texel(a.x, a.y, a.z, uintBitsToFloat(a.w), uintBitsToFloat(b.x), b.y, uintBitsToFloat(b.z),
               uintBitsToFloat(b.w));
}

void put_texel(uint pixel, texel t) {
  texels[2u * pixel] = uvec4(t.first, t.held, t.behind, floatBitsToUint(t.farthest));
  texels[2u * pixel + 1u] = uvec4(floatBitsToUint(t.last_depth), t.last_optical, floatBitsToUint(t.limit),
                                  floatBitsToUint(t.mean));
}

/// 1 over the view depth that units of moments end at, as bench/frame/scene has it.
float per_far() {
  const float far = VIEW.perspective ? distance(VIEW.eye, scene.centre) + scene.radius
                                     : 2.0 * float(VIEW.size.x) / VIEW.scale;
  return 1.0 / far;
}

/// Optical depth times depth. Sums wrap, beyond what any light passes.
uint moment(pelage_fragment f, float per_far) {
  return uint(float(f.id) * clamp(f.depth * per_far, 0.0, 1.0));
}

float mean_depth(uint moments, uint optical, float per_far) {
  return optical > 0u ? float(moments) / (float(optical) * per_far) : 0.0;
}

#endif
