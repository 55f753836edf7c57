// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What arrives at a point from a light, and what its map lets through, as bench/frame/lights.hpp and shadow_map.hpp
// have it.
#ifndef PELAGE_FRAME_LIGHTING_GLSL
#define PELAGE_FRAME_LIGHTING_GLSL
#include "pelage/glsl/composite/optical_depth.glsl"
#include "projection.glsl"

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

float transmittance_in(uint pixel, float depth) {
  if (depth > limits[pixel]) {
    return 0.0;
  }
  const uvec4 texel = texels[pixel];
  uint begin = 0u;
  uint end = texel.y;
  while (begin < end) {
    const uint middle = (begin + end) / 2u;
    if (uintBitsToFloat(entries[texel.x + middle].x) < depth) {
      begin = middle + 1u;
    } else {
      end = middle;
    }
  }
  const uvec2 last = begin > 0u ? entries[texel.x + begin - 1u] : uvec2(0u);
  uint optical = last.y;
  if (begin == texel.y && texel.z > 0u) {
    // Between the last entry and the farthest fragment the rest's optical depth grows linearly.
    const float from = uintBitsToFloat(last.x);
    const float span = uintBitsToFloat(texel.w) - from;
    const float share = span > 0.0 ? pelage_saturate((depth - from) / span) : 1.0;
    const float greatest = 4294967040.0;  // the last float below 2^32
    optical = pelage_add_saturating(optical, uint(share * min(float(texel.z), greatest)));
  }
  return pelage_transmittance_of(optical);
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
  const float top = mix(transmittance_in(first, depth), transmittance_in(first + 1u, depth), weight.x);
  const float bottom = mix(transmittance_in(below, depth), transmittance_in(below + 1u, depth), weight.x);
  return mix(top, bottom, weight.y);
}

#endif
