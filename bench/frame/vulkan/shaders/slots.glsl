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

/// Before the slots of a pixel are read.
void slots_begin(uint pixel) {}

/// The i-th nearest fragment of the pixel.
pelage_fragment slot_at(uint pixel, uint i) {
  return pelage_split_k_buffer_at(pixel, i);
}
#else
layout(std430, binding = 19) LIVE buffer slot_buffer { uint64_t slots[]; };
#define PELAGE_ATOMIC_CELLS_64_WORDS(i) slots[i]
#define PELAGE_ATOMIC_K_BUFFER_K K
#include "pelage/glsl/order/atomic_k_buffer.glsl"

pelage_fragment slots_sorted[K];

void slots_begin(uint pixel) {
  slots_sorted = pelage_atomic_k_buffer_load(pixel);
}

pelage_fragment slot_at(uint pixel, uint i) {
  return slots_sorted[i];
}
#endif

#endif
