// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 12u
#define RESULTS 24u
#include "table.glsl"

#include "pelage/glsl/bsdf/azimuthal.glsl"
#include "pelage/glsl/bsdf/hair_parameters.glsl"
#include "pelage/glsl/bsdf/longitudinal.glsl"

void main() {
  if (outside()) return;
  const float beta_m = f(0u);
  const float beta_n = f(1u);
  put(0u, pelage_longitudinal_variance(beta_m));
  put(1u, pelage_azimuthal_scale(beta_n));
  put(2u, pelage_roughness_of_width(f(2u)));
  const pelage_longitudinal_lobe along = pelage_make_longitudinal_lobe(pelage_longitudinal_variance(beta_m));
  put(3u, along.height);
  const pelage_fibre_direction light = pelage_fibre_direction_of(f(3u), f(5u), f(6u));
  const pelage_fibre_direction eye = pelage_fibre_direction_of(vec3(f(4u), f(6u), f(5u)));
  put(4u, light.cosine);
  put(5u, pelage_evaluate_longitudinal(along, light.sine, light.cosine, eye.sine, eye.cosine));
  const pelage_rotation inclination = pelage_sample_longitudinal(along, eye.sine, eye.cosine, f(7u), f(8u));
  put(6u, inclination.cosine);
  put(7u, inclination.sine);
  const pelage_azimuthal_lobe around = pelage_make_azimuthal_lobe(pelage_azimuthal_scale(beta_n));
  put(8u, around.height);
  put(9u, pelage_evaluate_azimuthal(around, f(9u)));
  put(10u, pelage_sample_azimuthal(around, f(7u)));
  const float sigma_a[3] = pelage_absorption_of(pelage_melanin(f(10u), f(11u)));
  put(11u, vec3(sigma_a[0], sigma_a[1], sigma_a[2]));
  const pelage_melanin pigment = pelage_melanin_from_controls(f(7u), f(8u));
  put(14u, pigment.eumelanin);
  put(15u, pigment.pheomelanin);
  put(16u, pelage_absorption_from_albedo(f(7u), beta_n));
  put(17u, pelage_albedo_from_absorption(f(10u), beta_n));
  const pelage_melanin brown = pelage_melanin_of(pelage_hair_colour_brown);
  put(18u, brown.eumelanin);
  put(19u, brown.pheomelanin);
  put(20u, pelage_sine_of_sum(light.sine, light.cosine, eye.sine, eye.cosine));
  put(21u, pelage_versine(pelage_rotation_by(f(9u))));
  put(22u, light.y);
  put(23u, light.z);
}
