// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
// What a driver does where it may fuse a multiplication with an addition: the mirror without its `precise`.
#define precise
#define STRIDE 3u
#define RESULTS 5u
#include "table.glsl"

#include "pelage/glsl/bsdf/fresnel.glsl"
#include "pelage/glsl/core/math.glsl"
#include "pelage/glsl/coverage/disc_strip.glsl"

void main() {
  if (outside()) return;
  put(0u, pelage_fast_log2(f(0u)));
  put(1u, pelage_fast_exp2(f(1u)));
  put(2u, pelage_power_of_cosine(f(2u), 20.0));
  put(3u, pelage_disc_strip_share(f(2u), 0.01, 0.5));
  put(4u, pelage_fresnel_dielectric(f(2u), 1.55));
}
