// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 3u
#define RESULTS 13u
#include "table.glsl"

#include "pelage/glsl/bsdf/bessel.glsl"
#include "pelage/glsl/core/elementary.glsl"

void main() {
  if (outside()) return;
  const float x = f(0u);
  const float u = f(1u);
  const float v = f(2u);
  put(0u, pelage_absolute(x));
  put(1u, pelage_least(u, v));
  put(2u, pelage_greatest(u, v));
  put(3u, pelage_exponential(u));
  put(4u, pelage_one_minus_exponential(pelage_absolute(u)));
  put(5u, pelage_natural_logarithm(x));
  const pelage_rotation turn = pelage_rotation_by(x);
  put(6u, turn.cosine);
  put(7u, turn.sine);
  put(8u, pelage_unsigned_angle(v, u));
  put(9u, pelage_angle_of(v, u));
  put(10u, pelage_angle_of_sine(u));
  const pelage_bessel_i0_parts bessel = pelage_bessel_i0(pelage_absolute(u));
  put(11u, bessel.value);
  put(12u, bessel.growth);
}
