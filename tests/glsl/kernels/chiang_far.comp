// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 14u
#define RESULTS 10u
#include "table.glsl"

#include "chiang.glsl"
#include "pelage/glsl/bsdf/chiang_far_field.glsl"
#include "pelage/glsl/bsdf/passage.glsl"

void main() {
  if (outside()) return;
  const pelage_chiang_result far = pelage_evaluate_chiang_far(fibre(), eye(), pelage_fibre_direction_of(v3(11u)));
  put(0u, far.value);
  put(3u, far.density);
  const float sigma_a[3] = float[3](f(1u), f(2u), f(3u));
  put(4u, pelage_axial_passage(f(0u), sigma_a, f(8u)));
  put(7u, pelage_mean_passage(f(0u), sigma_a, f(8u)));
}
