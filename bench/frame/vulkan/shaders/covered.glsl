// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// How much of each texel of the lights' maps fibres cover, all of them: what turns an optical depth into their number.
#ifndef PELAGE_FRAME_COVERED_GLSL
#define PELAGE_FRAME_COVERED_GLSL
#include "scene.glsl"

/// A texel: the sum of coverages in units of 2^-20, modulo 2^32, and whether it passed that end. All 0 at first.
layout(std430, binding = 25) buffer covered_buffer { uvec2 covered[]; };

/// As pelage_add_and_mark().
void add_covered(uint texel, uint amount) {
  if (amount != 0u && atomicAdd(covered[texel].x, amount) > 0xffffffffu - amount) {
    atomicOr(covered[texel].y, 1u);
  }
}

/// The sum, clamped to the end of its range.
float covered_by_fibres(uint texel) {
  return float(covered[texel].y != 0u ? 0xffffffffu : covered[texel].x);
}

#endif
