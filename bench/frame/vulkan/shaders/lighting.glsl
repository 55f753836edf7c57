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

float entry_depth(uint i) {
  return uintBitsToFloat(entries[i].x);
}

/// What the texel lets through whose `before` first entries lie before a depth.
float transmittance_behind(uvec4 texel, uint before, float depth) {
  const uvec2 last = before > 0u ? entries[texel.x + before - 1u] : uvec2(0u);
  uint optical = last.y;
  if (before == texel.y && texel.z > 0u) {
    // Between the last entry and the farthest fragment the rest's optical depth grows linearly.
    const float from = uintBitsToFloat(last.x);
    const float span = uintBitsToFloat(texel.w) - from;
    const float share = span > 0.0 ? pelage_saturate((depth - from) / span) : 1.0;
    const float greatest = 4294967040.0;  // the last float below 2^32
    optical = pelage_add_saturating(optical, uint(share * min(float(texel.z), greatest)));
  }
  return pelage_transmittance_of(optical);
}

/// What a square of four texels lets through, by rows. All four are searched at once: a search waits for each of its
/// loads, and so four wait together.
vec4 transmittance_in(uint pixel, uint below, float depth) {
  const uvec4 place = uvec4(pixel, pixel + 1u, below, below + 1u);
  uvec4 texel[4];
  uvec4 before = uvec4(0u);
  uint most = 0u;
  for (int t = 0; t < 4; ++t) {
    texel[t] = texels[place[t]];
    most = max(most, texel[t].y);
  }
  for (uint stride = most > 0u ? 1u << uint(findMSB(most)) : 0u; stride > 0u; stride /= 2u) {
    float probe[4];
    for (int t = 0; t < 4; ++t) {
      probe[t] = before[t] + stride <= texel[t].y ? entry_depth(texel[t].x + before[t] + stride - 1u) : depth;
    }
    for (int t = 0; t < 4; ++t) {
      before[t] += probe[t] < depth ? stride : 0u;
    }
  }
  vec4 passed;
  for (int t = 0; t < 4; ++t) {
    passed[t] = depth > limits[place[t]] ? 0.0 : transmittance_behind(texel[t], before[t], depth);
  }
  return passed;
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
