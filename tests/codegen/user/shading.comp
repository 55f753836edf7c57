// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
// A shader of a user: the own header's translation beside the mirror, for buffers of two sizes.
#define PELAGE_K_BUFFER_K 8
#include "shading.glsl"

#undef PELAGE_K_BUFFER_K
#define PELAGE_K_BUFFER_K 4
#define PELAGE_PREFIX small
#include "shading.glsl"
#undef PELAGE_PREFIX

layout(local_size_x = 8) in;
layout(std430, binding = 0) buffer results {
  vec4 result[];
};

void main() {
  pelage_k_buffer pixel = pelage_k_buffer_empty();
  pelage_k_buffer_insert(pixel, pelage_fragment(2.0, gl_GlobalInvocationID.x));
  small_k_buffer corner = small_k_buffer_empty();
  small_k_buffer_insert(corner, pelage_fragment(fur_nearest_depth(pixel), 1u));
  const fur_coat coat = fur_coat(vec3(0.5, 0.3, 0.1), 20.0);
  const vec3 light = fur_shade(coat, vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0));
  result[gl_GlobalInvocationID.x] = vec4(light, small_is_bare(corner) ? 0.0 : small_nearest_depth(corner));
}
