// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What shade.comp does, for the models of tabulated_fibre.glsl. In: points, seen, the lights' maps, tables, with
// DUAL_SCATTERING covered. Out: shaded. One invocation a point; bounded by scattered loads, those of the maps and 12 of
// a table a light.
#version 450
#extension GL_GOOGLE_include_directive : require
#ifdef DUAL_SCATTERING
#define COUNTS_FIBRES
#endif
#include "tabulated_fibre.glsl"

const float sky_share = 0.30;  ///< as bench/frame/shading has it

void shade(uint i) {
  const vec3 position = points[i].xyz;
  const vec3 tangent = triple_of_tangents(i);
  const vec3 to_eye = normalize(scene.views[scene.light_count].eye - position);
  vec3 sum = (sky_share * scene.sky + scene.ambient) * reflect_sky(tangent, to_eye);
  for (uint l = 0u; l < scene.light_count; ++l) {
    const arrival light = light_at(l, position);
    passage passed = passage(1.0, 0.0, 1.0);
    if (scene.shadows) {
      passed = passage_to_point(l, i, tangent);
    }
    sum += light.colour * scatter(tangent, light.to_light, to_eye, passed, opacities[i]);
  }
  const vec3 held = min(sum, vec3(65504.0));  // the largest half
  const float opacity = scene.translucent ? opacities[VIEW.first_opacity + i] : 1.0;
  shaded[i] = uvec2(packHalf2x16(held.xy), packHalf2x16(vec2(held.z, opacity)));
}

/// The points of the segments that are seen: no segment begins at the last point of a strand.
void main() {
  const uint i = invocation();
  if (i < uint(points.length()) && (seen[i] != 0u || seen[max(i, 1u) - 1u] != 0u)) {
    shade(i);
  }
}
