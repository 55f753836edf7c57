// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Lights the strands' points that the camera sees. In: points and what they are made of, seen, the lights' maps. Out:
// shaded. One invocation a point; bounded by the maps' scattered loads, some 30 a light.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "pelage/glsl/bsdf/kajiya_kay.glsl"
#include "lighting.glsl"

// As bench/frame/shading has them.
const float sky_share = 0.30;

void shade(uint i) {
  const vec3 position = points[i].xyz;
  const vec3 tangent = triple_of_tangents(i);
  const vec3 colour = triple_of_colours(i);
  const vec3 to_eye = normalize(scene.views[scene.light_count].eye - position);
  vec3 sum = (sky_share * scene.sky + scene.ambient) * colour;
  for (uint l = 0u; l < scene.light_count; ++l) {
    const arrival light = light_at(l, position);
    const float passed = scene.shadows ? transmittance_to_point(l, i, tangent) : 1.0;
    const pelage_kajiya_kay_lobes lobes = pelage_kajiya_kay(tangent, light.to_light, to_eye, scene.exponent);
    sum += passed * light.colour * (scene.diffuse * lobes.diffuse * colour + vec3(scene.specular * lobes.specular));
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
