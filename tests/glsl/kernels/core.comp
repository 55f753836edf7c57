// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 6u
#define RESULTS 13u
#include "table.glsl"

#include "pelage/glsl/core/fragment.glsl"
#include "pelage/glsl/core/math.glsl"

void main() {
  if (outside()) return;
  const pelage_fragment a = pelage_fragment(f(0u), u(1u));
  const pelage_fragment b = pelage_fragment(f(2u), u(3u));
  put(0u, pelage_is_fragment(a));
  put(1u, pelage_before(a, b));
  put(2u, pelage_same(a, b));
  put(3u, pelage_depth_key(a.depth));
  put(4u, pelage_depth_from_key(u(1u)));
  put(5u, pelage_saturate(f(0u)));
  put(6u, pelage_sqr(f(4u)));
  put(7u, pelage_safe_sqrt(f(4u)));
  put(8u, pelage_fast_log2(f(4u)));
  put(9u, pelage_fast_exp2(f(5u)));
  put(10u, pelage_power_of_cosine(pelage_saturate(f(4u)), abs(f(5u))));
  const pelage_fragment none = pelage_no_fragment();
  put(11u, none.depth);
  put(12u, none.id);
}
