// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 16u
#define RESULTS 26u
#include "table.glsl"

#include "pelage/glsl/bsdf/bessel.glsl"
#include "pelage/glsl/bsdf/fresnel.glsl"
#include "pelage/glsl/bsdf/interface.glsl"
#include "pelage/glsl/core/elementary.glsl"
#include "pelage/glsl/core/vector_math.glsl"

void main() {
  if (outside()) return;
  put(0u, pelage_exponential(f(0u)));
  put(1u, pelage_small_exponential(f(0u) / 256.0));
  put(2u, pelage_one_minus_exponential(f(1u)));
  put(3u, pelage_natural_logarithm(f(2u)));
  put(4u, pelage_power_of_share(f(3u), f(4u)));
  put(5u, pelage_unsigned_angle(f(5u), f(6u)));
  put(6u, pelage_angle_of(f(5u), f(6u)));
  put(7u, pelage_angle_of_sine(f(7u)));
  const pelage_rotation turn = pelage_rotation_by(f(8u));
  put(8u, turn.cosine);
  put(9u, turn.sine);
  const pelage_bessel_i0_parts bessel = pelage_bessel_i0(f(9u));
  put(10u, bessel.value);
  put(11u, pelage_log_bessel_i0(f(9u)));
  const pelage_interface_shares surface = pelage_dielectric_interface(f(3u), f(15u));
  put(12u, surface.reflected);
  put(13u, surface.transmitted);
  const pelage_interface_shares inclined = pelage_bravais_interface(f(3u), abs(f(7u)), f(15u), 1.25 * f(15u));
  put(14u, inclined.reflected);
  put(15u, inclined.transmitted);
  put(16u, pelage_fresnel_dielectric(f(3u), f(15u)));
  const vec3 a = v3(9u);
  const vec3 b = v3(12u);
  put(17u, pelage_dot_product(a, b));
  put(18u, pelage_cross_product(a, b));
  put(21u, pelage_cross_product(b, b).x);
  put(22u, pelage_vector_length(b));
  put(23u, pelage_unit_vector(b));
}
