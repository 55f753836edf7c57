// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 14u
#define RESULTS 9u
#include "table.glsl"

#include "chiang.glsl"
#include "pelage/glsl/bsdf/chiang_sampling.glsl"

void main() {
  if (outside()) return;
  const pelage_fibre_direction light = pelage_fibre_direction_of(v3(11u));
  const pelage_chiang_result result = pelage_evaluate_chiang(fibre(), view(), light);
  put(0u, result.value);
  put(3u, result.density);
  put(4u, pelage_chiang_density(fibre(), view(), light));
  const pelage_chiang_bsdf whole = pelage_evaluate_chiang_bsdf(fibre(), f(7u), v3(8u), v3(11u));
  put(5u, whole.f);
  put(8u, whole.density);
}
