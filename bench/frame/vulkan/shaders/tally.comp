// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Adds up a view's fragments, for the report; not part of a frame. In: counts. Out: reports.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (is_inside(at)) {
    const uint count = counts[VIEW.first_pixel + index_of(at)];
    const uint before = atomicAdd(reports[this_view()].fragments, count);
    if (before + count < count) {
      atomicAdd(reports[this_view()].carries, 1u);
    }
    atomicMax(reports[this_view()].longest, count);
  }
}
