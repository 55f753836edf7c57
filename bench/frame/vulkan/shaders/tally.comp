// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Adds up what a view's runs hold, for the report; not part of a frame. In: runs, counts. Out: reports.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (is_inside(at)) {
    const uint held = min(counts[index_of(at)], runs[index_of(at)].y) - runs[index_of(at)].x;
    atomicAdd(reports[push.view].fragments, held);
    atomicMax(reports[push.view].longest, held);
  }
}
