// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
// PASS: 1 offers depths, 2 offers fragments, 3 reads the slots.
#include "slots.glsl"

#define PELAGE_SPLIT_K_BUFFER_K 8
#define PELAGE_ATOMIC_CELLS_WORDS(i) held[i]
#include "pelage/glsl/order/split_k_buffer.glsl"

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= uint(offered.length())) return;
#if PASS == 1
  pelage_split_k_buffer_offer_depth(i % pixels, offered[i]);
#elif PASS == 2
  lost[i] = pelage_split_k_buffer_insert(i % pixels, offered[i]);
#else
  if (i < 8u * pixels) lost[i] = pelage_split_k_buffer_at(i / 8u, i % 8u);
#endif
}
