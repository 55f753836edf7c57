// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 13u
#define RESULTS 6u
#include "table.glsl"

#include "pelage/glsl/bsdf/kajiya_kay_highlights.glsl"

void main() {
  if (outside()) return;
  const pelage_double_highlight both = pelage_kajiya_kay_double(
      v3(0u), v3(3u), v3(6u), pelage_highlight_shape(f(9u), f(10u)), pelage_highlight_shape(f(11u), f(12u)));
  put(0u, both.primary);
  put(1u, both.secondary);
  put(2u, pelage_shifted_tangent(v3(0u), v3(3u), f(10u)));
  put(5u, pelage_normalised_fibre_diffuse(f(11u)));
}
