// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#define WIDE
#include "slots.glsl"

#define PELAGE_ATOMIC_K_BUFFER_K 8
#define PELAGE_CASCADE_K_BUFFER_K 8
#define PELAGE_ATOMIC_CELLS_64_WORDS(i) held[i]
#include "pelage/glsl/order/atomic_k_buffer.glsl"
#include "pelage/glsl/order/cascade_k_buffer.glsl"

void main() {
  const uint i = gl_GlobalInvocationID.x;
#ifdef READ
  if (i >= pixels) return;
#ifdef CASCADE
  for (uint j = 0u; j < 8u; ++j)
    lost[8u * i + j] = pelage_cascade_k_buffer_at(i, j);
#else
  const pelage_fragment nearest[8] = pelage_atomic_k_buffer_load(i);
  for (uint j = 0u; j < 8u; ++j)
    lost[8u * i + j] = nearest[j];
#endif
#else
  if (i >= uint(offered.length())) return;
#ifdef CASCADE
  lost[i] = pelage_cascade_k_buffer_insert(i % pixels, offered[i]);
#else
  lost[i] = pelage_atomic_k_buffer_insert(i % pixels, offered[i]);
#endif
#endif
}
