// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 29u
#define RESULTS 47u
#include "table.glsl"

#include "pelage/glsl/bsdf/dual_scattering_table.glsl"

void main() {
  if (outside()) return;
  const pelage_dual_averages averages = pelage_dual_averages(v3(0u), v3(3u), v3(6u), v3(9u), v3(12u), v3(15u));
  const pelage_dual_density density = pelage_dual_density(f(18u), f(19u));
  const pelage_dual_local local = pelage_dual_local_scattering(averages, density);
  put(0u, local.albedo);
  put(3u, local.shift);
  put(6u, local.variance);
  const pelage_dual_global global = pelage_dual_global_scattering(averages, density, f(20u), f(21u));
  put(9u, global.direct);
  put(10u, global.transmitted);
  put(13u, global.variance);
  const pelage_dual_global passed =
      pelage_dual_pass_fibre(pelage_dual_pass_fibre(pelage_dual_unshadowed(), averages, density), averages, density);
  put(16u, passed.direct);
  put(17u, passed.transmitted);
  put(20u, passed.variance);
  put(23u, pelage_dual_scattering(averages, local, global, density, v3(22u), f(25u), f(26u), f(27u)));
  put(26u, pelage_detail_dual_lobe(f(6u), f(12u), f(18u), f(19u)));
  const pelage_dual_table_place place = pelage_dual_table_place_of(f(25u), 1u + u(28u));
  put(27u, float(place.low) + place.share);
  put(28u, float(place.high));
  const pelage_dual_averages other = pelage_dual_averages(v3(3u), v3(0u), v3(9u), v3(6u), v3(15u), v3(12u));
  const pelage_dual_averages blend = pelage_blend_dual_averages(averages, other, f(18u));
  put(29u, blend.forward);
  put(32u, blend.backward);
  put(35u, blend.forward_shift);
  put(38u, blend.backward_shift);
  put(41u, blend.forward_variance);
  put(44u, blend.backward_variance);
}
