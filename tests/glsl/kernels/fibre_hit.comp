// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 14u
#define RESULTS 14u
#include "table.glsl"

#include "pelage/glsl/bsdf/fibre_hit.glsl"

void main() {
  if (outside()) return;
  const pelage_fibre_hit at = pelage_fibre_hit_on_segment(v3(0u), v3(3u), v3(6u), v3(9u), f(12u), f(13u));
  put(0u, at.h);
  put(1u, at.gamma);
  put(2u, at.theta);
  put(3u, at.eye.sine);
  put(4u, at.eye.cosine);
  put(5u, pelage_into_frame(at.frame, v3(3u)));
  put(8u, pelage_out_of_frame(at.frame, v3(3u)));
  put(11u, pelage_fibre_hit_of(v3(0u), v3(3u), v3(6u), f(12u)).frame.z);
}
