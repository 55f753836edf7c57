// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
// Two sizes in one shader: the one of K by its default name, and one of 5 as small_k_buffer.
#define OFFERED 24u
#define STRIDE (2u * OFFERED)
#define RESULTS (2u * OFFERED + 2u * K + 3u + 10u)
#ifndef K
#define K 16
#endif
#include "table.glsl"

#define PELAGE_K_BUFFER_K K
#include "pelage/glsl/order/k_buffer.glsl"

#undef PELAGE_K_BUFFER_K
#define PELAGE_K_BUFFER_K 5
#define PELAGE_PREFIX small
#include "pelage/glsl/order/k_buffer.glsl"
#undef PELAGE_PREFIX

void main() {
  if (outside()) return;
  pelage_k_buffer near = pelage_k_buffer_empty();
  pelage_k_buffer rest = pelage_k_buffer_empty();
  small_k_buffer nearest = small_k_buffer_empty();
  for (uint i = 0u; i < OFFERED; ++i) {
    const pelage_fragment offered = pelage_fragment(f(2u * i), u(2u * i + 1u));
    pelage_fragment lost = offered;
    if (i % 3u == 2u) {
      lost = pelage_k_buffer_insert(rest, offered);
    } else {
      lost = pelage_k_buffer_insert(near, offered);
    }
    put(2u * i, lost.depth);
    put(2u * i + 1u, lost.id);
    const pelage_fragment dropped = small_k_buffer_insert(nearest, offered);
  }
  pelage_k_buffer_merge(near, rest);
  pelage_k_buffer_sort(near);
  small_k_buffer_sort(nearest);
  for (uint i = 0u; i < K; ++i) {
    put(2u * (OFFERED + i), near.slot[i].depth);
    put(2u * (OFFERED + i) + 1u, near.slot[i].id);
  }
  put(2u * (OFFERED + K), pelage_k_buffer_size(near));
  put(2u * (OFFERED + K) + 1u, near.farthest_slot);
  put(2u * (OFFERED + K) + 2u, pelage_k_buffer_size(rest));
  for (uint i = 0u; i < 5u; ++i) {
    put(2u * (OFFERED + K + i) + 3u, nearest.slot[i].depth);
    put(2u * (OFFERED + K + i) + 4u, nearest.slot[i].id);
  }
}
