// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// K slots a pixel as the library's cells: one of 64 bits each, or with SPLIT two of 32.
#ifndef PELAGE_FRAME_SLOTS_GLSL
#define PELAGE_FRAME_SLOTS_GLSL
#include "scene.glsl"

#ifdef SPLIT
layout(std430, binding = 19) LIVE buffer slot_buffer { uint slots[]; };
#define PELAGE_ATOMIC_CELLS_WORDS(i) slots[i]
#define PELAGE_SPLIT_K_BUFFER_K K
#include "pelage/glsl/order/split_k_buffer.glsl"

pelage_fragment slot_at(uint pixel, uint i) {
  return pelage_split_k_buffer_at(pixel, i);
}
#else
layout(std430, binding = 19) LIVE buffer slot_buffer { uint64_t slots[]; };
#define PELAGE_ATOMIC_CELLS_64_WORDS(i) slots[i]
#define PELAGE_CASCADE_K_BUFFER_K K
#include "pelage/glsl/order/cascade_k_buffer.glsl"

pelage_fragment slot_at(uint pixel, uint i) {
  return pelage_cascade_k_buffer_at(pixel, i);
}
#endif

#endif
