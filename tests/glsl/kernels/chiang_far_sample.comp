// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 15u
#define RESULTS 8u
#include "table.glsl"

#include "chiang.glsl"
#include "pelage/glsl/bsdf/chiang_far_field.glsl"

void main() {
  if (outside()) return;
  const pelage_chiang_sample drawn =
      pelage_sample_chiang_far(fibre(), eye(), float[4](f(11u), f(12u), f(13u), f(14u)));
  put(0u, drawn.direction);
  put(3u, vec3(drawn.result.value[0], drawn.result.value[1], drawn.result.value[2]));
  put(6u, drawn.result.density);
  put(7u, float(drawn.lobe));
}
