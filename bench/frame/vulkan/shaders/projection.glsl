// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A view's projection, as bench/frame/scene/view.hpp has it.
#ifndef PELAGE_FRAME_PROJECTION_GLSL
#define PELAGE_FRAME_PROJECTION_GLSL
#include "pelage/glsl/coverage/ray_cone.glsl"
#include "scene.glsl"

struct view_ray {
  vec3 origin;
  vec3 direction;  ///< z = -1: a position along it is a view depth
};

/// A dot product of the same bits in every shader.
precise float steady_dot(vec3 a, vec3 b) {
  return fma(a.z, b.z, fma(a.y, b.y, a.x * b.x));
}

precise vec3 direction_to_view(uint v, vec3 d) {
  return vec3(steady_dot(scene.views[v].right, d), steady_dot(scene.views[v].up, d),
              steady_dot(scene.views[v].back, d));
}

precise vec3 to_view(uint v, vec3 world) {
  return direction_to_view(v, world - scene.views[v].eye);
}

vec3 direction_to_world(uint v, vec3 d) {
  return d.x * scene.views[v].right + d.y * scene.views[v].up + d.z * scene.views[v].back;
}

/// A point nearer than the near plane is taken to lie on it.
precise vec2 to_pixel(uint v, vec3 p) {
  const float depth = -p.z > scene.views[v].near_plane ? -p.z : scene.views[v].near_plane;
  const float s = scene.views[v].perspective ? scene.views[v].scale / depth : scene.views[v].scale;
  const vec2 middle = 0.5 * vec2(scene.views[v].size);
  return vec2(fma(s, p.x, middle.x), fma(-s, p.y, middle.y));
}

/// A pixel's width at a point in view space.
float pixel_at(uint v, vec3 p) {
  return (scene.views[v].perspective ? max(-p.z, scene.views[v].near_plane) : 1.0) / scene.views[v].scale;
}

precise view_ray ray_through(uint v, vec2 pixel) {
  const vec2 middle = 0.5 * vec2(scene.views[v].size);
  const vec3 across =
      vec3((pixel.x - middle.x) / scene.views[v].scale, (middle.y - pixel.y) / scene.views[v].scale, 0.0);
  const vec3 ahead = vec3(0.0, 0.0, -1.0);
  return scene.views[v].perspective ? view_ray(vec3(0.0), across + ahead) : view_ray(across, ahead);
}

pelage_ray_cone cone_of(uint v) {
  return pelage_ray_cone(scene.views[v].cone_base, scene.views[v].cone_slope);
}

#endif
