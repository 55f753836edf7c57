// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#define WIDE
#include "slots.glsl"

#define PELAGE_ATOMIC_K_BUFFER_K 8
#define PELAGE_ATOMIC_CELLS_64_WORDS(i) held[i]
#include "pelage/glsl/order/atomic_k_buffer.glsl"

void main() {
  const uint i = gl_GlobalInvocationID.x;
#ifdef READ
  if (i >= pixels) return;
  const pelage_fragment nearest[8] = pelage_atomic_k_buffer_load(i);
  for (uint j = 0u; j < 8u; ++j)
    lost[8u * i + j] = nearest[j];
#else
  if (i >= uint(offered.length())) return;
  lost[i] = pelage_atomic_k_buffer_insert(i % pixels, offered[i]);
#endif
}
