// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What arrives at a point from a light, and what its map lets through, as bench/frame/scene/lights.hpp and shadows/shadow_map.hpp
// have it.
#ifndef PELAGE_FRAME_LIGHTING_GLSL
#define PELAGE_FRAME_LIGHTING_GLSL
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

/// A texel's width at a world position.
float texel_at(uint l, vec3 world) {
  return 2.0 * pelage_radius_at(cone_of(l), -to_view(l, world).z);
}

/// The share of a light that reaches a world position: four texels, weighted bilinearly.
float transmittance_to(uint l, vec3 world, float bias) {
  const vec3 p = to_view(l, world);
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
  const vec4 passed = transmittance_in(first, below, depth);
  const float top = mix(passed.x, passed.y, weight.x);
  const float bottom = mix(passed.z, passed.w, weight.x);
  return mix(top, bottom, weight.y);
}

#endif
