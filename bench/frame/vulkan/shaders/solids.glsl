// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The opaque objects and what a ray meets of them, as bench/frame/scene/solids.hpp, model/ellipsoid.hpp and
// placement.hpp have it.
#ifndef PELAGE_FRAME_SOLIDS_GLSL
#define PELAGE_FRAME_SOLIDS_GLSL
#include "projection.glsl"

struct solid_hit {
  float distance;  ///< in lengths of the ray's direction; infinite where it meets nothing
  bool is_floor;
};

vec3 turned_copy(uint i, vec3 d) {
  const float c = scene.copies[i].cosine;
  const float s = scene.copies[i].sine;
  return vec3(c * d.x + s * d.z, d.y, c * d.z - s * d.x);
}

vec3 turned_back(uint i, vec3 d) {
  const float c = scene.copies[i].cosine;
  const float s = scene.copies[i].sine;
  return vec3(c * d.x - s * d.z, d.y, c * d.z + s * d.x);
}

vec3 place_of_copy(uint i) {
  return vec3(scene.copies[i].at.x, 0.0, scene.copies[i].at.y);
}

/// False where a ray's line passes the sphere by.
bool is_met(sphere_block body, vec3 origin, vec3 direction) {
  const vec3 from = origin - body.centre;
  const float along = dot(from, direction);
  return dot(from, from) - along * along / dot(direction, direction) < body.radius * body.radius;
}

bool holds(sphere_block body, vec3 p) {
  const vec3 from = p - body.centre;
  return dot(from, from) < body.radius * body.radius;
}

/// Where a ray first enters a part of a body. Entries count that lie at most `within` of a part's first radius before
/// the origin.
float entry_of_parts(vec3 origin, vec3 direction, float within) {
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

/// Where a ray first enters a body.
float first_entry(vec3 origin, vec3 direction, float within) {
  if (scene.copy_count == 0u) {
    return entry_of_parts(origin, direction, within);
  }
  float nearest = uintBitsToFloat(0x7f800000u);
  for (uint first = 0u; first < scene.copy_count; first += cluster_size) {
    if (!is_met(scene.clusters[first / cluster_size], origin, direction)) {
      continue;
    }
    for (uint i = first; i < min(first + cluster_size, scene.copy_count); ++i) {
      if (is_met(scene.bodies[i], origin, direction)) {
        const vec3 origin_there = turned_back(i, origin - place_of_copy(i));
        nearest = min(nearest, entry_of_parts(origin_there, turned_back(i, direction), within));
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

/// The normals of the parts whose surfaces pass close to p, weighted by nearness and summed.
vec3 sum_of_normals(vec3 p) {
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
  return sum;
}

vec3 shading_normal(vec3 p) {
  if (scene.copy_count == 0u) {
    return normalize(sum_of_normals(p));
  }
  vec3 sum = vec3(0.0);
  for (uint first = 0u; first < scene.copy_count; first += cluster_size) {
    if (!holds(scene.clusters[first / cluster_size], p)) {
      continue;
    }
    for (uint i = first; i < min(first + cluster_size, scene.copy_count); ++i) {
      if (holds(scene.bodies[i], p)) {
        sum += turned_copy(i, sum_of_normals(turned_back(i, p - place_of_copy(i))));
      }
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
