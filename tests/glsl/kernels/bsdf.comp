// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 11u
#define RESULTS 5u
#include "table.glsl"

#include "pelage/glsl/bsdf/fresnel.glsl"
#include "pelage/glsl/bsdf/kajiya_kay.glsl"

void main() {
  if (outside()) return;
  put(0u, pelage_fresnel_dielectric(f(0u), 1.0 + f(9u)));
  put(1u, pelage_fibre_attenuation(1.0 + f(9u), f(0u)));
  put(2u, pelage_fibre_opacity(1.0 + f(9u), f(0u)));
  const pelage_kajiya_kay_lobes lobes = pelage_kajiya_kay(v3(0u), v3(3u), v3(6u), f(10u));
  put(3u, lobes.diffuse);
  put(4u, lobes.specular);
}
