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
};

layout(std430, binding = 12) buffer texel_buffer { uvec4 texels[]; };  ///< two a pixel of a light

texel texel_in(uint pixel) {
  const uvec4 a = texels[2u * pixel];
  const uvec4 b = texels[2u * pixel + 1u];
  return texel(a.x, a.y, a.z, uintBitsToFloat(a.w), uintBitsToFloat(b.x), b.y, uintBitsToFloat(b.z));
}

void put_texel(uint pixel, texel t) {
  texels[2u * pixel] = uvec4(t.first, t.held, t.behind, floatBitsToUint(t.farthest));
  texels[2u * pixel + 1u] = uvec4(floatBitsToUint(t.last_depth), t.last_optical, floatBitsToUint(t.limit), 0u);
}

#endif
