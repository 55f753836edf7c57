// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What arrives at a point from a light, and what its map lets through, as bench/frame/scene/lights.hpp and shadows/shadow_map.hpp
// have it.
#ifndef PELAGE_FRAME_LIGHTING_GLSL
#define PELAGE_FRAME_LIGHTING_GLSL
#include "pelage/glsl/visibility/receiver.glsl"
#include "projection.glsl"
#ifdef OCCUPANCY
#include "occupancy_shadow.glsl"
#else
#include "nearest_shadow.glsl"
#endif

struct arrival {
  vec3 to_light;
  vec3 colour;
};

arrival light_at(uint l, vec3 at) {
  const light_block light = scene.lights[l];
  if (light.kind == 0u) {
    return arrival(-light.direction, light.colour);
  }
  const vec3 way = light.position - at;
  const vec3 centre_way = light.position - scene.centre;
  const float distance2 = max(dot(way, way), 1e-30);
  const vec3 to_light = way / sqrt(distance2);
  float strength = dot(centre_way, centre_way) / distance2;
  if (light.kind == 2u) {
    strength *= smoothstep(light.cos_outer, light.cos_inner, -dot(to_light, light.direction));
  }
  return arrival(to_light, strength * light.colour);
}

// As bench/frame/shadows/shadow_map.cpp has them.
const float steepest = 64.0;

/// How far a position lies from a light; of a directional one the greatest float.
float distance_to(uint l, vec3 at) {
  return scene.lights[l].kind == 0u ? 3.40282347e38 : length(scene.lights[l].position - at);
}

/// The way of a light through a position in its view.
vec3 ray_to(uint l, vec3 p) {
  return scene.views[l].perspective ? vec3(p.xy / max(-p.z, scene.views[l].near_plane), -1.0) : vec3(0.0, 0.0, -1.0);
}

/// The share of a light that reaches a position in its view: four texels, weighted bilinearly, each up to the depth of
/// a receiver with this slope there. `among_fibres`: objects stop nothing.
float transmittance_to(uint l, vec3 p, vec2 slope, float bias, bool among_fibres) {
  const float depth = -p.z - bias;
  if (depth <= scene.views[l].near_plane) {
    return 1.0;
  }
  const vec2 pixel = to_pixel(l, p) - 0.5;
  const vec2 corner = floor(pixel);
  const vec2 weight = pixel - corner;
  const ivec2 size = scene.views[l].size;
  if (!(corner.x >= 0.0 && corner.y >= 0.0 && corner.x < float(size.x - 1) && corner.y < float(size.y - 1))) {
    return 1.0;
  }
  const uint first = scene.views[l].first_pixel + uint(corner.y) * uint(size.x) + uint(corner.x);
  const uint below = first + uint(size.x);
  const vec2 growth = pixel_at(l, p) * vec2(slope.x, -slope.y);
  const float there = depth - dot(weight, growth);
  const vec4 depths = there + vec4(0.0, growth.x, growth.y, growth.x + growth.y);
  const vec4 passed = transmittance_in(first, below, depths, among_fibres);
  const float top = mix(passed.x, passed.y, weight.x);
  const float bottom = mix(passed.z, passed.w, weight.x);
  return mix(top, bottom, weight.y);
}

float transmittance_to_fibre(uint l, vec3 world, vec3 tangent, float radius) {
  const vec3 p = to_view(l, world);
  const vec2 slope = pelage_line_depth_slope(ray_to(l, p), direction_to_view(l, tangent), steepest);
  return transmittance_to(l, p, slope, 2.0 * radius, false);
}

/// The same of a point on an object's surface, without what objects hide.
float transmittance_to_surface(uint l, vec3 world, vec3 normal) {
  const vec3 p = to_view(l, world);
  const vec2 slope = pelage_plane_depth_slope(ray_to(l, p), direction_to_view(l, normal), steepest);
  return transmittance_to(l, p, slope, 0.0, true);
}

#endif
