// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The wind, as bench/frame/model/sway.hpp has it, from the words that a dispatch brings.
#ifndef PELAGE_FRAME_SWAY_GLSL
#define PELAGE_FRAME_SWAY_GLSL
#include "projection.glsl"

/// Two parabolas a turn, in [-1, 1].
precise float wave(float turns) {
  const float u = clamp(turns - floor(turns + 0.5), -0.5, 0.5);
  return u * fma(abs(u), -16.0, 8.0);
}

precise vec3 force_at(vec3 place) {
  const float gust = wave(steady_dot(place, vec3(0.45, 0.1, 0.2)) - push.wind_phase[0]);
  const float ripple = wave(steady_dot(place, vec3(0.7, -0.8, -0.3)) - push.wind_phase[1]);
  const float swirl = wave(steady_dot(place, vec3(0.3, 0.4, 0.7)) - push.wind_phase[2]);
  return vec3(fma(0.15, ripple, fma(0.35, gust, 0.35)), fma(0.2, ripple, 0.1), 0.35 * swirl);
}

/// Where a point is that rests at a place, its strand's first point at `root`.
precise vec3 moved(vec3 place, vec3 root) {
  const vec3 arm = place - root;
  const vec3 force = force_at(push.wind_scale * place);
  const float square = steady_dot(arm, arm);
  const float along = steady_dot(arm, force);
  const vec3 pushed = push.wind_bend * (square * force - along * arm);
  const float tangent2 =
      push.wind_bend * push.wind_bend * max(fma(square, steady_dot(force, force), -(along * along)), 0.0);
  return place + (2.0 / (1.0 + tangent2)) * (pushed - tangent2 * arm);
}

#endif
