// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Marschner's, Chiang's and dual scattering's fibres by the tables of bench/frame/shading, as fibre_bsdf.hpp there has
// them: MARSCHNER, CHIANG or DUAL_SCATTERING.
#ifndef PELAGE_FRAME_TABULATED_FIBRE_GLSL
#define PELAGE_FRAME_TABULATED_FIBRE_GLSL
#include "passage.glsl"
#include "pelage/glsl/bsdf/chiang.glsl"
#include "pelage/glsl/bsdf/dual_scattering_table.glsl"
#include "pelage/glsl/bsdf/marschner_table.glsl"

const uint azimuthal_rows = 64u;     ///< sines of inclination from 0 to 1
const uint azimuthal_columns = 256u;  ///< azimuths from 0 to π
const uint inclinations = 48u;        ///< of averages

struct azimuthal_row {
  vec3 residual;
  vec3 passage;
  vec3 backward;
};

layout(std430, binding = 24) readonly buffer bsdf_buffer {
  pelage_chiang_fibre chiang;
  float alpha;  ///< Marschner's
  float beta;
  azimuthal_row azimuthal[azimuthal_rows];
  pelage_dual_averages averages[inclinations];  ///< of dual scattering
  pelage_marschner_lobes lobes[];               ///< N, rows of inclination, columns of azimuth
} bsdf;

const float pi = 3.14159265;
const pelage_dual_density density = pelage_dual_density(0.7, 0.7);

/// Both directions as the models take them.
struct fibre_angles {
  pelage_rotation light;  ///< cos and sin of the inclinations
  pelage_rotation eye;
  float phi;  ///< azimuth between them, [0, π]
};

pelage_rotation inclination_of(vec3 tangent, vec3 direction) {
  const float sine = clamp(dot(tangent, direction), -1.0, 1.0);
  return pelage_rotation(sqrt((1.0 - sine) * (1.0 + sine)), sine);
}

fibre_angles angles_of(vec3 tangent, vec3 to_light, vec3 to_eye) {
  const pelage_rotation light = inclination_of(tangent, to_light);
  const pelage_rotation eye = inclination_of(tangent, to_eye);
  const float across = abs(dot(tangent, cross(to_light, to_eye)));
  const float along = dot(to_light, to_eye) - light.sine * eye.sine;
  return fibre_angles(light, eye, min(pi, pelage_unsigned_angle(across, along)));
}

pelage_marschner_lobes lobes_at(float sin_theta, float phi) {
  const pelage_marschner_table_place place =
      pelage_marschner_table_place_of(sin_theta, phi, azimuthal_rows, azimuthal_columns);
  pelage_marschner_lobes sum = pelage_marschner_lobes(vec3(0.0), vec3(0.0), vec3(0.0));
  for (uint corner = 0u; corner < 4u; ++corner) {
    const pelage_marschner_lobes n = bsdf.lobes[place.entry[corner]];
    sum.reflected += place.weight[corner] * n.reflected;
    sum.transmitted += place.weight[corner] * n.transmitted;
    sum.returned += place.weight[corner] * n.returned;
  }
  return sum;
}

azimuthal_row azimuthal_at(float sin_theta) {
  const float place = min(abs(sin_theta), 1.0) * float(azimuthal_rows - 1u);
  const uint row = min(uint(place), azimuthal_rows - 2u);
  const azimuthal_row a = bsdf.azimuthal[row];
  const azimuthal_row b = bsdf.azimuthal[row + 1u];
  const float share = place - float(row);
  return azimuthal_row(mix(a.residual, b.residual, share), mix(a.passage, b.passage, share),
                       mix(a.backward, b.backward, share));
}

pelage_dual_averages averages_at(float theta) {
  const pelage_dual_table_place place = pelage_dual_table_place_of(theta, inclinations);
  return pelage_blend_dual_averages(bsdf.averages[place.low], bsdf.averages[place.high], place.share);
}

float sin_half_difference(float theta_from, float theta_to) {
  return pelage_rotation_by(0.5 * (theta_to - theta_from)).sine;
}

float cos2_of(float sine) {
  return max((1.0 - sine) * (1.0 + sine), 1e-12);
}

vec3 marschner_share(fibre_angles a) {
  const float theta_i = pelage_angle_of_sine(a.light.sine);
  const float theta_r = pelage_angle_of_sine(a.eye.sine);
  const float theta_h = 0.5 * (theta_i + theta_r);
  const float sin_theta_d = sin_half_difference(theta_i, theta_r);
  const pelage_marschner_lobes n = lobes_at(sin_theta_d, a.phi);
  const vec3 sum = pelage_gaussian(theta_h - bsdf.alpha, bsdf.beta) * n.reflected +
                   pelage_gaussian(theta_h + 0.5 * bsdf.alpha, 0.5 * bsdf.beta) * n.transmitted +
                   pelage_gaussian(theta_h + 1.5 * bsdf.alpha, 2.0 * bsdf.beta) * n.returned;
  return 0.5 * a.light.cosine / cos2_of(sin_theta_d) * sum;
}

vec3 chiang_share(fibre_angles a) {
  const pelage_fibre_direction eye = pelage_fibre_direction(a.eye.sine, a.eye.cosine, 1.0, 0.0);
  const pelage_fibre_direction light = pelage_fibre_direction(a.light.sine, a.light.cosine, 1.0, 0.0);
  const pelage_chiang_view seen = pelage_view_chiang(bsdf.chiang, 0.0, eye);  // its inclinations alone are of use
  const float m[4] = pelage_chiang_inclinations(bsdf.chiang, seen, light);
  const pelage_marschner_lobes n = lobes_at(a.eye.sine, a.phi);
  return m[0] * n.reflected + m[1] * n.transmitted + m[2] * n.returned + m[3] * azimuthal_at(a.eye.sine).residual;
}

vec3 dual_share(fibre_angles a, passage passed, float opacity) {
  if (!(passed.open > 0.0)) {
    return vec3(0.0);
  }
  const float theta_i = pelage_angle_of_sine(a.light.sine);
  const float theta_r = pelage_angle_of_sine(a.eye.sine);
  const pelage_dual_averages averages = averages_at(theta_i);
  const pelage_dual_local local = pelage_dual_local_scattering(averages, density);
  const pelage_dual_global global = pelage_dual_global_scattering(averages, density, opacity * passed.fibres,
                                                                  passed.transmittance / passed.open);
  const vec3 many = pelage_dual_scattering(averages, local, global, density, vec3(0.0), theta_i, theta_r, a.phi);
  const float cos2_theta_d = cos2_of(sin_half_difference(theta_i, theta_r));
  return passed.transmittance * chiang_share(a) +
         passed.open * a.eye.cosine * a.light.cosine / cos2_theta_d * many;
}

/// The light that arrives where a fibre passes the share `kept` of what it meets.
vec3 arriving(passage passed, vec3 kept) {
  if (!(passed.transmittance > 0.0)) {
    return vec3(0.0);
  }
  const float octaves = pelage_fast_log2(min(passed.transmittance / passed.open, 1.0));
  const vec3 lost = (1.0 - min(kept, vec3(1.0))) * octaves;
  return passed.open * vec3(pelage_fast_exp2(lost.r), pelage_fast_exp2(lost.g), pelage_fast_exp2(lost.b));
}

/// Radiance toward the eye for light of unit colour.
vec3 scatter(vec3 tangent, vec3 to_light, vec3 to_eye, passage passed, float opacity) {
  const fibre_angles a = angles_of(tangent, to_light, to_eye);
#ifdef DUAL_SCATTERING
  return pi * dual_share(a, passed, opacity);
#else
#ifdef MARSCHNER
  const vec3 share = marschner_share(a);
#else
  const vec3 share = chiang_share(a);
#endif
  const vec3 arrives = scene.eta > 0.0 ? vec3(passed.transmittance)  // of which A has the lobe's part
                                       : arriving(passed, azimuthal_at(a.light.sine).passage);
  return pi * arrives * share;
#endif
}

/// Radiance toward the eye for a sky of radiance 1.
vec3 reflect_sky(vec3 tangent, vec3 to_eye) {
  const float sin_eye = inclination_of(tangent, to_eye).sine;
#ifdef DUAL_SCATTERING
  const pelage_dual_averages averages = averages_at(pelage_angle_of_sine(sin_eye));
  return 2.0 * (averages.backward + 4.0 / 3.0 * density.backward * pelage_dual_local_scattering(averages, density).albedo);
#else
  return 2.0 * azimuthal_at(sin_eye).backward;
#endif
}

#endif
