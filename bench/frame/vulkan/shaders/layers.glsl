// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What depth peeling keeps of a pixel: the layer that was taken last, the nearest fragment behind it so far, and what
// is seen of the layers up to the last (fronts.glsl). 48 bytes.
#ifndef PELAGE_FRAME_LAYERS_GLSL
#define PELAGE_FRAME_LAYERS_GLSL
#include "fronts.glsl"

layout(std430, binding = 19) LIVE buffer slot_buffer { uint64_t slots[]; };  ///< two a pixel: last, nearest
#define PELAGE_ATOMIC_CELLS_64_WORDS(i) slots[i]
#include "pelage/glsl/core/atomic_cells_64.glsl"
#include "pelage/glsl/order/packed_fragment.glsl"

uint last_slot(uint pixel) {
  return 2u * pixel;
}

uint nearest_slot(uint pixel) {
  return 2u * pixel + 1u;
}

#endif
