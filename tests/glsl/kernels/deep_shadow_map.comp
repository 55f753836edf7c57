// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
// Each invocation builds a deep shadow map in vertices of its own and looks it up.
#define FRAGMENTS 12u
#define STRIDE (2u * FRAGMENTS + 2u)
#define RESULTS 4u
#include "table.glsl"

#include "pelage/glsl/visibility/deep_shadow_vertex.glsl"
pelage_deep_shadow_vertex vertex[2u * FRAGMENTS];
#define PELAGE_SPAN_VERTEX_STORAGE_VERTICES(i) vertex[i]
#include "pelage/glsl/visibility/deep_shadow_map.glsl"

uint built(float max_error) {
  pelage_deep_shadow_builder builder = pelage_deep_shadow_builder_begin(0u, max_error);
  precise float depth = f(2u * FRAGMENTS);
  for (uint i = 0u; i < FRAGMENTS; ++i) {
    depth += f(2u * i);
    pelage_deep_shadow_builder_add(builder, depth, f(2u * i + 1u));
  }
  pelage_deep_shadow_builder_finish(builder);
  return builder.count;
}

void main() {
  if (outside()) return;
  const float look = f(2u * FRAGMENTS + 1u);
  const uint exact = built(0.0);
  put(0u, exact);
  put(1u, pelage_deep_shadow_at(0u, exact, look));
  const uint rough = built(0.05);
  const float transmittance = pelage_deep_shadow_at(0u, rough, look);
  put(2u, transmittance);
  put(3u, transmittance);
}
