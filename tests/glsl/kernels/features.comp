// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
// Each feature of the subset, as pelage-glsl translates it.
#define STRIDE 13u
#define RESULTS 23u
#include "table.glsl"

#include "../../codegen/features.glsl"

void main() {
  if (outside()) return;
  const vec4 a = v4(0u);
  const vec4 b = v4(4u);
  put(0u, features_switched(u(8u), u(9u)));
  put(1u, features_loops(u(9u)));
  put(2u, features_ranges(float[4](a.x, a.y, a.z, a.w)));
  put(3u, features_bit_counts(u(10u), b.x));
  put(4u, uint(features_choices(int(u(10u)), int(u(11u)))));
  put(5u, features_vectors(a.xyz, b));
  uint quotient = 0u;
  uint rest = 0u;
  features_divide(u(10u), u(9u) + 1u, quotient, rest);
  put(8u, quotient);
  put(9u, rest);
  put(10u, features_members(a.x, a.y, features_third));
  put(11u, features_wide(u(10u), u(11u)));
  put(12u, features_limits(f(12u)));
  features_ring ring = features_empty_ring();
  for (uint i = 0u; i < 12u; ++i) {
    features_ring_push(ring, u(i));
  }
  put(13u, features_fold(ring));
  put(14u, features_kind_frizzy);
  put(15u, features_sample_pair_sum(features_sample_pair_of(a.x, a.y)));
  put(16u, features_weights[1]);
  put(17u, features_half_pi);
  put(18u, features_folded(a.x));
  put(19u, features_operators(features_sample_pair_of(a.x, a.y), a.z));
  put(20u, features_by_type(a.x));
  put(21u, features_conversions(a.x, a.y, int(u(10u) % 7u) - 3));
  put(22u, features_copies(a.xyz, b.xyz, features_turn(a.w, b.w)));
}
