// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The picture from the peeled layers. In: fronts, edges, picture. Out: picture. One invocation a pixel; bounded by 76 bytes a
// pixel.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "camera_sink.glsl"
#include "layers.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  sink_begin(at, false);
  sink_pixel = load_fronts(index_of(at));
  sink_finish(at);
}
