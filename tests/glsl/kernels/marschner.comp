// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 13u
#define RESULTS 48u
#include "table.glsl"

#include "pelage/glsl/bsdf/marschner_table.glsl"

void put(uint column, float value[3]) { put(column, vec3(value[0], value[1], value[2])); }

void main() {
  if (outside()) return;
  pelage_marschner_parameters hair = pelage_common_marschner_parameters(float[3](f(1u), f(2u), f(3u)));
  hair.eta = f(0u);
  hair.alpha = f(4u);
  hair.beta = f(5u);
  hair.eccentricity = f(6u);
  const pelage_marschner_result smoothed = pelage_evaluate_marschner(hair, f(7u), f(8u), f(9u), f(10u));
  hair.caustic.smoothed = false;
  const pelage_marschner_result bare = pelage_evaluate_marschner(hair, f(7u), f(8u), f(9u), f(10u));
  put(0u, bare.longitudinal);
  put(3u, bare.azimuthal[0]);
  put(6u, bare.azimuthal[1]);
  put(9u, bare.azimuthal[2]);
  put(12u, smoothed.azimuthal[2]);
  put(15u, bare.scattering);
  put(18u, smoothed.scattering);
  const pelage_fibre_section section = pelage_make_fibre_section(hair.eta, 0.5 * (f(8u) - f(7u)));
  put(21u, section.eta_perpendicular);
  put(22u, section.eta_parallel);
  put(23u, section.excess);
  put(24u, section.path_stretch);
  const pelage_caustic_point caustic = pelage_find_caustic(section.excess);
  put(25u, caustic.sine);
  put(26u, caustic.cosine);
  put(27u, caustic.half_azimuth);
  put(28u, caustic.curvature);
  const int path = int(u(11u) % 3u);
  const pelage_scattering_roots roots = pelage_find_scattering_roots(path, f(9u), section.excess);
  put(29u, float(roots.count));
  put(30u, vec3(roots.root[0].sine, roots.root[1].sine, roots.root[2].sine));
  put(33u, pelage_path_attenuation(section, path, f(12u), sqrt(1.0 - f(12u) * f(12u)), f(1u)));
  put(34u, pelage_azimuth_derivative(path, f(12u), section.eta_perpendicular));
  put(35u, pelage_eccentric_index(hair.eta, hair.eccentricity, f(10u)));
  put(36u, pelage_table_coordinate(f(12u), 256u));
  const pelage_marschner_lobes lobes = pelage_azimuthal_lobes(section, hair, f(9u));
  put(37u, lobes.reflected);
  put(40u, lobes.transmitted);
  put(43u, lobes.returned);
  const pelage_marschner_table_place place = pelage_marschner_table_place_of(f(12u), f(9u), 64u, 256u);
  vec2 where = vec2(0.0);
  for (uint corner = 0u; corner < 4u; ++corner) {
    where += place.weight[corner] * vec2(place.entry[corner] / 256u, place.entry[corner] % 256u);
  }
  put(46u, where.x);
  put(47u, where.y);
}
