// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What fibres stop of a view's rays by Fresnel's equations, each point by its own inclination to the ray through it, as
// bench/frame/raster/view_opacity.hpp has it. In: points, tangents. Out: opacities. One invocation a point of a view;
// bounded by 28 bytes read a point.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "pelage/glsl/bsdf/fresnel.glsl"
#include "projection.glsl"

layout(std430, binding = 4) writeonly buffer view_opacity_buffer { float view_opacities[]; };

void main() {
  const uint i = invocation();
  if (i < uint(points.length())) {
    const vec3 ray = VIEW.perspective ? points[i].xyz - VIEW.eye : -VIEW.back;
    const float sine = steady_dot(triple_of_tangents(i), ray) / sqrt(steady_dot(ray, ray));
    view_opacities[VIEW.first_opacity + i] = pelage_fibre_opacity(scene.eta, sine);
  }
}
