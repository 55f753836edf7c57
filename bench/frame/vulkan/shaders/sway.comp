// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Moves the hair to where the wind has it. In: rest. Out: points, their radii as they were, and tangents. One invocation
// a point, which moves its neighbours as well; bounded by 16 bytes read and 24 written a point.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sway.glsl"

struct rest_point {
  vec3 place;
  uint root;  ///< number of its strand's first point
};

layout(std430, binding = 1) writeonly buffer moved_point_buffer { vec4 moved_points[]; };
layout(std430, binding = 2) writeonly buffer moved_tangent_buffer { float moved_tangents[]; };
layout(std430, binding = 27) readonly buffer rest_buffer { rest_point rest[]; };

vec3 place_of(uint i) {
  return moved(rest[i].place, rest[rest[i].root].place);
}

/// From the point before to the one after.
vec3 way_past(uint i) {
  const uint root = rest[i].root;
  const uint after = i + 1u < uint(rest.length()) && rest[i + 1u].root == root ? i + 1u : i;
  return place_of(after) - place_of(i > root ? i - 1u : i);
}

/// Where neighbours lie on each other, that of the nearest point before where they do not.
vec3 tangent_at(uint i) {
  for (uint at = i;; --at) {
    const vec3 way = way_past(at);
    const float square = steady_dot(way, way);
    if (square > 0.0) {
      return way / sqrt(square);
    }
    if (at == rest[i].root) {
      return vec3(0.0, 1.0, 0.0);
    }
  }
}

void main() {
  const uint i = invocation();
  if (i < uint(rest.length())) {
    moved_points[i].xyz = place_of(i);
    const vec3 tangent = tangent_at(i);
    moved_tangents[3u * i] = tangent.x;
    moved_tangents[3u * i + 1u] = tangent.y;
    moved_tangents[3u * i + 2u] = tangent.z;
  }
}
