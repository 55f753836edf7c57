// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 2u
#define RESULTS 5u
#include "table.glsl"

void main() {
  if (outside()) return;
  precise const float sum = f(0u) + f(1u);
  precise const float difference = f(0u) - f(1u);
  precise const float product = f(0u) * f(1u);
  put(0u, sum);
  put(1u, difference);
  put(2u, product);
  put(3u, f(0u) / f(1u));
  put(4u, sqrt(f(0u)));
}
