// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What light has met on its way to a fibre, as bench/frame/shadows/shadow_map.hpp has it.
#ifndef PELAGE_FRAME_PASSAGE_GLSL
#define PELAGE_FRAME_PASSAGE_GLSL
#include "lighting.glsl"
#ifdef COUNTS_FIBRES
#include "covered.glsl"
#endif

struct passage {
  float transmittance;
  float fibres;  ///< passed, each counted by the share of the texel that it covers; 0 without COUNTS_FIBRES
  float open;    ///< the share that no opaque object stops
};

/// Fibres in each texel of a square, of which this is the optical depth before the receiver and that of all.
vec4 fibres_in(map_square s, vec4 optical, vec4 whole) {
#ifdef COUNTS_FIBRES
  const vec4 covered = vec4(covered_by_fibres(s.first), covered_by_fibres(s.first + 1u), covered_by_fibres(s.below),
                            covered_by_fibres(s.below + 1u));
  const vec4 per_octave = mix(covered / max(whole, vec4(1.0)), vec4(0.0), equal(whole, vec4(0.0)));
  return 1.0 / 1048576.0 * optical * per_octave;
#else
  return vec4(0.0);
#endif
}

/// Behind an opaque object the fibres are all those before it.
passage passage_to_point(uint l, uint i, vec3 tangent) {
  const map_square s = square_at_point(l, i, tangent);
  if (!s.is_inside) {
    return passage(1.0, 0.0, 1.0);
  }
  const vec4 hidden_from = vec4(limits[s.first], limits[s.first + 1u], limits[s.below], limits[s.below + 1u]);
  const bvec4 hidden = greaterThan(s.depths, hidden_from);
  const float farthest = 3.40282347e38;
  vec4 optical;
  vec4 whole;
  optical_in(s.first, s.below, mix(s.depths, vec4(farthest), hidden), optical, whole);
  const vec4 open = mix(vec4(1.0), vec4(0.0), hidden);
  const vec4 passed = open * vec4(pelage_transmittance_of(optical.x), pelage_transmittance_of(optical.y),
                                  pelage_transmittance_of(optical.z), pelage_transmittance_of(optical.w));
  return passage(mean_in(s, passed), mean_in(s, fibres_in(s, optical, whole)), mean_in(s, open));
}

#endif
