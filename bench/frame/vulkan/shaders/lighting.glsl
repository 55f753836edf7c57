// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What arrives at a point from a light, and what its map lets through, as bench/frame/scene/lights.hpp and shadows/shadow_map.hpp
// have it.
#ifndef PELAGE_FRAME_LIGHTING_GLSL
#define PELAGE_FRAME_LIGHTING_GLSL
#include "pelage/glsl/visibility/lookup_jitter.glsl"
#include "pelage/glsl/visibility/receiver.glsl"
#include "projection.glsl"
#ifdef OCCUPANCY
#include "occupancy_shadow.glsl"
#elif defined(LAYERED)
#include "layered_shadow.glsl"
#else
#include "nearest_shadow.glsl"
#endif

#ifndef LAYERED
void look_up_light(uint l) {}  // a texel says all
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

/// Where a light's map is looked up: four texels, each up to the depth that the receiver has there.
struct map_square {
  bool is_inside;
  uint first;  ///< the upper left texel
  uint below;  ///< the lower left one
  vec2 weight;
  vec4 depths;  ///< by rows
};

const map_square no_square = map_square(false, 0u, 0u, vec2(0.0), vec4(0.0));

/// One whose upper left texel is `corner`. `depth`: the receiver's at that texel's centre; `growth`: a texel on.
map_square square_from(uint l, vec2 corner, vec2 weight, float depth, vec2 growth) {
  const uint width = uint(scene.views[l].size.x);
  const uint first = scene.views[l].first_pixel + uint(corner.y) * width + uint(corner.x);
  return map_square(true, first, first + width, weight,
                    depth + vec4(0.0, growth.x, growth.y, growth.x + growth.y));
}

/// Of a receiver with this slope at a position in the light's view.
map_square square_at(uint l, vec3 p, vec2 slope, float bias) {
  look_up_light(l);
  const float depth = -p.z - bias;
  const vec2 pixel = to_pixel(l, p) - 0.5;
  const vec2 corner = floor(pixel);
  const ivec2 size = scene.views[l].size;
  const bool is_inside = depth > scene.views[l].near_plane && corner.x >= 0.0 && corner.y >= 0.0 &&
                         corner.x < float(size.x - 1) && corner.y < float(size.y - 1);
  if (!is_inside) {
    return no_square;
  }
  const vec2 weight = pixel - corner;
  const vec2 growth = pixel_at(l, p) * vec2(slope.x, -slope.y);
  return square_from(l, corner, weight, depth - dot(weight, growth), growth);
}

map_square square_at_fibre(uint l, vec3 world, vec3 tangent, float radius) {
  const vec3 p = to_view(l, world);
  const vec2 slope = pelage_line_depth_slope(ray_to(l, p), direction_to_view(l, tangent), steepest);
  return square_at(l, p, slope, 2.0 * radius);
}

/// A square that weighs one texel alone: the one that holds the position moved by lookup_jitter().
map_square jittered_square_at_fibre(uint l, vec3 world, vec3 tangent, float radius, uint seed) {
  look_up_light(l);
  const vec3 p = to_view(l, world);
  const float depth = -p.z - 2.0 * radius;
  const vec2 pixel = to_pixel(l, p);
  const vec2 size = vec2(scene.views[l].size);
  const bool is_inside = depth > scene.views[l].near_plane && all(greaterThanEqual(pixel, vec2(0.0))) &&
                         all(lessThanEqual(pixel, size));
  if (!is_inside) {
    return no_square;
  }
  const vec2 texel = min(floor(max(pixel + pelage_lookup_jitter(seed), 0.0)), size - 1.0);
  const vec2 corner = min(texel, size - 2.0);
  const vec2 slope = pelage_line_depth_slope(ray_to(l, p), direction_to_view(l, tangent), steepest);
  const vec2 growth = pixel_at(l, p) * vec2(slope.x, -slope.y);
  return square_from(l, corner, texel - corner, depth + dot(corner + 0.5 - pixel, growth), growth);
}

/// Where the light of a strand's point is looked up.
map_square square_at_point(uint l, uint i, vec3 tangent) {
#ifdef JITTERED
  return jittered_square_at_fibre(l, points[i].xyz, tangent, points[i].w, pelage_mixed_bits(i));
#else
  return square_at_fibre(l, points[i].xyz, tangent, points[i].w);
#endif
}

/// The mean of what four texels hold, weighted bilinearly.
float mean_in(map_square s, vec4 held) {
  return mix(mix(held.x, held.y, s.weight.x), mix(held.z, held.w, s.weight.x), s.weight.y);
}

/// The share of the light that passes. `among_fibres`: objects stop nothing.
float transmittance_in(map_square s, bool among_fibres) {
  return s.is_inside ? mean_in(s, transmittance_in(s.first, s.below, s.depths, among_fibres)) : 1.0;
}

float transmittance_to_point(uint l, uint i, vec3 tangent) {
  const map_square s = square_at_point(l, i, tangent);
#ifdef JITTERED
  const uint texel = (s.weight.y > 0.0 ? s.below : s.first) + uint(s.weight.x);
  return s.is_inside ? transmittance_at(texel, mean_in(s, s.depths), false) : 1.0;
#else
  return transmittance_in(s, false);
#endif
}

/// The same of a point on an object's surface, without what objects hide.
float transmittance_to_surface(uint l, vec3 world, vec3 normal) {
  const vec3 p = to_view(l, world);
  const vec2 slope = pelage_plane_depth_slope(ray_to(l, p), direction_to_view(l, normal), steepest);
  return transmittance_in(square_at(l, p, slope, 0.0), true);
}

#endif
