// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The picture from what is seen of all fibres. In: fronts, edges, picture. Out: picture. One invocation a pixel; bounded by 76 bytes a
// pixel.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "camera_sink.glsl"
#include "fronts.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  sink_begin(at, false);
  sink_pixel = load_fronts(index_of(at));
  sink_finish(at);
}
