// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The opaque objects and what a ray meets of them, as bench/frame/scene/solids.hpp and model/ellipsoid.hpp have it.
#ifndef PELAGE_FRAME_SOLIDS_GLSL
#define PELAGE_FRAME_SOLIDS_GLSL
#include "projection.glsl"

struct solid_hit {
  float distance;  ///< in lengths of the ray's direction; infinite where it meets nothing
  bool is_floor;
};

/// Where a ray first enters a part. Entries count that lie at most `within` of a part's first radius before the origin.
float first_entry(vec3 origin, vec3 direction, float within) {
  float nearest = uintBitsToFloat(0x7f800000u);
  for (uint i = 0u; i < scene.part_count; ++i) {
    const vec3 o = (origin - scene.parts[i].centre) / scene.parts[i].radii;
    const vec3 d = direction / scene.parts[i].radii;
    const float a = dot(d, d);
    const float half_b = dot(o, d);
    const vec3 closest = o - (half_b / a) * d;
    const float depth = 1.0 - dot(closest, closest);
    if (depth > 0.0) {
      const float t = -half_b / a - sqrt(depth / a);
      if (t > -within * scene.parts[i].radii.x) {
        nearest = min(nearest, t);
      }
    }
  }
  return nearest;
}

/// Down to the floor; infinite for a ray that does not get there.
float fall(vec3 origin, vec3 direction) {
  const bool falls = scene.has_floor && direction.y < 0.0 && origin.y > scene.floor_height;
  return falls ? (scene.floor_height - origin.y) / direction.y : uintBitsToFloat(0x7f800000u);
}

solid_hit hit_solids(vec3 origin, vec3 direction) {
  const float entry = first_entry(origin, direction, 0.0);
  const float below = fall(origin, direction);
  return below < entry ? solid_hit(below, true) : solid_hit(entry, false);
}

/// The length of the unobstructed way from a point on an object's surface; about 0 or less for a direction into it.
float free_way(vec3 surface, vec3 direction) {
  const float rounding = 2e-3;  // as bench/frame/scene/solids.hpp has it
  return min(first_entry(surface, direction, rounding), fall(surface, direction));
}

/// The normals of the parts whose surfaces pass close to p, weighted by nearness.
vec3 shading_normal(vec3 p) {
  const float reach = 0.12;
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < scene.part_count; ++i) {
    const vec3 radii = scene.parts[i].radii;
    const vec3 from = p - scene.parts[i].centre;
    const float nearness = 1.0 - abs(length(from / radii) - 1.0) / reach;
    if (nearness > 0.0) {
      sum += normalize(from / (radii * radii)) * (nearness * nearness);
    }
  }
  return normalize(sum);
}

/// View depth of the nearest opaque object along the ray through pixel coordinates.
float opaque_depth(vec2 pixel) {
  const view_ray ray = ray_through(this_view(), pixel);
  const vec3 origin = VIEW.eye + direction_to_world(this_view(), ray.origin);
  return hit_solids(origin, direction_to_world(this_view(), ray.direction)).distance;
}

/// Where one of the nine samples of a pixel lies, or the only one.
vec2 sample_position(ivec2 at, uint i, uint side) {
  return vec2(at) + (vec2(float(i % side), float(i / side)) + 0.5) / float(side);
}

#endif
