// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What the camera sees behind the fibres: the opaque objects, lit, and the sky, by samples. In: the lights' maps,
// edges. Out: edges, picture. One invocation a pixel; bounded by the maps' scattered loads where an object is seen.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "edge.glsl"
#include "lighting.glsl"
#include "solids.glsl"

vec3 sky_toward(vec3 direction) {
  const float up = 0.5 + 0.5 * normalize(direction).y;
  return scene.sky * mix(vec3(0.62, 0.63, 0.66), vec3(1.05, 1.08, 1.14), up);
}

vec3 solid_radiance(vec3 position, vec3 normal) {
  vec3 sum = 0.5 * (1.0 + 0.3 * normal.y) * scene.sky + scene.ambient;
  for (uint l = 0u; l < scene.light_count; ++l) {
    const arrival light = light_at(l, position);
    const float facing = dot(normal, light.to_light);
    if (facing > 0.0) {
      float passed = 1.0;
      if (scene.shadows) {
        const bool open = distance_to(l, position) < free_way(position, light.to_light);
        passed = open ? transmittance_to_surface(l, position, normal) : 0.0;
      }
      sum += passed * facing * light.colour;
    }
  }
  return sum;
}

struct seen_sample {
  vec3 radiance;
  float depth;
};

seen_sample seen_along(view_ray ray) {
  const vec3 origin = VIEW.eye + direction_to_world(this_view(), ray.origin);
  const vec3 direction = direction_to_world(this_view(), ray.direction);
  const vec3 far = sky_toward(direction);
  const solid_hit hit = hit_solids(origin, direction);
  if (isinf(hit.distance)) {
    return seen_sample(far, hit.distance);
  }
  const vec3 position = origin + hit.distance * direction;
  if (!hit.is_floor) {
    return seen_sample(scene.skin * solid_radiance(position, shading_normal(position)), hit.distance);
  }
  const float way = hit.distance * length(direction);
  const float haze = smoothstep(scene.floor_clear, 2.0 * scene.floor_clear, way);
  return seen_sample(mix(scene.ground * solid_radiance(position, vec3(0.0, 1.0, 0.0)), far, haze), hit.distance);
}

void main() {
  const ivec2 at = pixel_of(invocation());
  if (!is_inside(at)) {
    return;
  }
  const uint side = scene.antialias ? 3u : 1u;
  const float count = float(side * side);
  const uint e = first_of_edge(index_of(at));
  const float parting = edges[e];
  vec3 sum = vec3(0.0);
  vec3 far_sum = vec3(0.0);
  float near_depths = 0.0;
  float near_count = 0.0;
  for (uint i = 0u; i < side * side; ++i) {
    const seen_sample seen = seen_along(ray_through(this_view(), sample_position(at, i, side)));
    sum += seen.radiance;
    if (seen.depth < parting) {
      near_depths += seen.depth;
      near_count += 1.0;
    } else {
      far_sum += seen.radiance;
    }
  }
  const bool is_divided = near_count > 0.0 && near_count < count;
  edges[e] = is_divided ? near_depths / near_count : uintBitsToFloat(0x7f800000u);
  edges[e + 1u] = (count - near_count) / count;
  const vec3 far_light = far_sum / count;
  edges[e + 2u] = far_light.r;
  edges[e + 3u] = far_light.g;
  edges[e + 4u] = far_light.b;
  sum /= count;
  const uint p = 3u * index_of(at);
  picture[p] = sum.r;
  picture[p + 1u] = sum.g;
  picture[p + 2u] = sum.b;
}
