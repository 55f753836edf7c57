// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A segment in a view and what it leaves in a pixel, exact coverage included, as bench/frame/raster/raster.hpp has it.
#ifndef PELAGE_FRAME_RASTER_GLSL
#define PELAGE_FRAME_RASTER_GLSL
#include "pelage/glsl/composite/optical_depth.glsl"
#include "pelage/glsl/coverage/closest_points.glsl"
#include "pelage/glsl/coverage/disc_strip.glsl"
#include "line.glsl"
#include "projection.glsl"

/// What a segment leaves in a pixel.
struct segment_in_pixel {
  float depth;
  float coverage;
  float along;
};

/// A segment in view space.
struct placed_segment {
  vec3 start;
  vec3 end;
  float start_radius;
  float end_radius;
};

precise placed_segment place(uint i) {
  const vec4 a = points[i];
  const vec4 b = points[i + 1u];
  return placed_segment(to_view(this_view(), a.xyz), to_view(this_view(), b.xyz), a.w, b.w);
}

/// Where a pixel's ray passes a segment that touches the pixel.
precise segment_in_pixel look_at(placed_segment s, ivec2 at) {
  const bool smooth_edges = scene.antialias || !is_camera();
  if (draws_lines) {
    const vec3 found = line_in_pixel(s.start, s.end, s.start_radius, s.end_radius, at, smooth_edges);
    return segment_in_pixel(found.x, found.y, found.z);
  }
  const view_ray ray = ray_through(this_view(), vec2(at) + 0.5);
  const pelage_closest_pair pair = pelage_closest_points(ray.origin, ray.direction, s.start, s.end);
  const float disc = pelage_radius_at(cone_of(this_view()), pair.along_ray);
  const float fibre = s.start_radius + pair.along_segment * (s.end_radius - s.start_radius);
  const float hit = pair.distance <= max(fibre, disc) ? 1.0 : 0.0;
  const float share = smooth_edges ? pelage_disc_strip_share(pair.distance, fibre, disc) : hit;
  const float axis_depth = -(s.start.z + pair.along_segment * (s.end.z - s.start.z));
  const bool in_front = min(pair.along_ray, axis_depth) >= VIEW.near_plane;
  return segment_in_pixel(pair.along_ray, in_front ? share : 0.0, pair.along_segment);
}

#endif
