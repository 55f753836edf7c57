// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// One row of inputs and one row of results for each invocation. STRIDE and RESULTS: words in a row.
layout(local_size_x_id = 0) in;
layout(std430, binding = 0) readonly buffer inputs {
  uint given[];
};
layout(std430, binding = 1) buffer outputs {
  uint results[];
};

uint u(uint column) { return given[gl_GlobalInvocationID.x * STRIDE + column]; }
float f(uint column) { return uintBitsToFloat(u(column)); }
vec2 v2(uint column) { return vec2(f(column), f(column + 1u)); }
vec3 v3(uint column) { return vec3(v2(column), f(column + 2u)); }
vec4 v4(uint column) { return vec4(v3(column), f(column + 3u)); }

void put(uint column, uint value) { results[gl_GlobalInvocationID.x * RESULTS + column] = value; }
void put(uint column, bool value) { put(column, value ? 1u : 0u); }
void put(uint column, float value) { put(column, floatBitsToUint(value)); }
void put(uint column, vec3 value) {
  put(column, value.x);
  put(column + 1u, value.y);
  put(column + 2u, value.z);
}
void put(uint column, vec4 value) {
  put(column, value.xyz);
  put(column + 3u, value.w);
}

bool outside() { return (gl_GlobalInvocationID.x + 1u) * STRIDE > uint(given.length()); }
