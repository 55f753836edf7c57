// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define FRAGMENTS 8u
#define STRIDE (4u * FRAGMENTS + 4u)
#define RESULTS 28u
#include "table.glsl"

#define PELAGE_ATOMIC_CELLS_WORDS(i) results[i]
#include "pelage/glsl/composite/alpha_layers.glsl"
#include "pelage/glsl/composite/optical_depth.glsl"
#include "pelage/glsl/composite/power_moments.glsl"
#include "pelage/glsl/composite/trigonometric_moments.glsl"

uint next = 0u;
void give(uint value) { put(next++, value); }
void give(float value) { put(next++, value); }
void give(vec3 value) {
  put(next, value);
  next += 3u;
}

void main() {
  if (outside()) return;
  const float at = f(4u * FRAGMENTS);
  const vec3 colour = v3(4u * FRAGMENTS + 1u);
  pelage_power_moments moments = pelage_power_moments_empty();
  pelage_power_moments others = pelage_power_moments_empty();
  pelage_trigonometric_moments angles = pelage_trigonometric_moments_empty();
  pelage_alpha_layers layers = pelage_alpha_layers_empty();
  for (uint i = 0u; i < FRAGMENTS; ++i) {
    const float relative = f(4u * i);
    const float alpha = f(4u * i + 1u);
    if (i % 2u == 0u) {
      pelage_power_moments_add(moments, relative, pelage_optical_depth(alpha));
    } else {
      pelage_power_moments_add(others, relative, pelage_optical_depth(alpha));
    }
    pelage_trigonometric_moments_add(angles, relative, pelage_optical_depth(alpha));
    pelage_alpha_layers_insert(layers, pelage_fragment(f(4u * i + 2u), u(4u * i + 3u)), alpha, colour * float(i));
  }
  pelage_power_moments_merge(moments, others);
  for (uint i = 0u; i < 5u; ++i) give(moments.sum[i]);
  const pelage_power_visibility told = pelage_power_moments_visibility(moments);
  const pelage_moment_bounds bounds = pelage_power_visibility_bounds_before(told, at);
  const uint own = pelage_optical_depth(f(1u));
  give(pelage_transmittance_of(bounds.least));
  give(pelage_transmittance_of(bounds.most));
  give(pelage_transmittance_of(pelage_power_visibility_amount_before(told, at)));
  give(pelage_transmittance_of(pelage_power_visibility_amount_before_fragment(told, f(0u), own)));
  for (uint i = 0u; i < 4u; ++i) give(layers.layer[i].nearest.id);
  give(pelage_alpha_layers_transmittance(layers));
  give(pelage_alpha_layers_resolve(layers, colour.zyx));
  give(moments.sum[PELAGE_POWER_MOMENTS_N]);
  for (uint i = 0u; i < 5u; ++i) give(angles.sum[i]);
  give(angles.sum[2u * PELAGE_TRIGONOMETRIC_MOMENTS_N]);
  const pelage_trigonometric_visibility circle = pelage_trigonometric_moments_visibility(angles);
  const pelage_moment_bounds interval = pelage_trigonometric_visibility_interval_before(circle, at);
  give(pelage_transmittance_of(interval.least));
  give(pelage_transmittance_of(interval.most));
  give(pelage_transmittance_of(pelage_trigonometric_visibility_amount_before(circle, at)));
  give(pelage_transmittance_of(pelage_trigonometric_visibility_amount_before_fragment(circle, f(0u), own)));
}
