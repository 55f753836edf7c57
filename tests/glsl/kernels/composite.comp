// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 12u
#define RESULTS 50u
#include "table.glsl"

#include "pelage/glsl/composite/divided_pixel.glsl"
#include "pelage/glsl/composite/optical_depth.glsl"
#include "pelage/glsl/composite/over.glsl"
#include "pelage/glsl/composite/radiance.glsl"
#include "pelage/glsl/composite/sliced_tail.glsl"
#include "pelage/glsl/composite/tail.glsl"
#include "pelage/glsl/composite/transmittance.glsl"

void main() {
  if (outside()) return;
  const vec3 colour = v3(0u);
  const float alpha = f(3u);
  const vec4 back = v4(4u);
  put(0u, pelage_transmittance(colour, alpha));
  put(3u, pelage_transmittance(colour.x, alpha));
  put(4u, pelage_premultiply(colour, alpha));
  put(8u, pelage_over(pelage_premultiply(colour, alpha), back));
  put(12u, pelage_optical_depth(alpha));
  put(13u, pelage_add_saturating(u(8u), u(9u)));
  put(14u, pelage_transmittance_of(u(8u)));
  pelage_tail tail = pelage_empty_tail();
  tail = pelage_add_fragment(tail, alpha, colour);
  tail = pelage_add_fragment(tail, f(7u), back.xyz);
  tail = pelage_merge(tail, pelage_tail(u(8u), u(9u), u(10u), u(11u), 1u));
  put(15u, tail.optical);
  put(16u, tail.weight);
  put(17u, tail.red);
  put(18u, tail.green);
  put(19u, tail.blue);
  put(20u, pelage_to_fixed(f(0u)));
  put(21u, pelage_transmittance_of(tail));
  put(22u, pelage_mean_colour(tail));
  pelage_pixel_radiance pixel = pelage_empty_pixel();
  pixel = pelage_add_fibre(pixel, colour, back.xyz, alpha);
  pixel = pelage_add_fibre(pixel, back.xyz, colour, f(7u));
  put(25u, pixel.transmittance);
  put(28u, pelage_resolve(pixel, colour));
  pixel = pelage_add_fibre(pelage_empty_pixel(), colour, back.xyz, f(7u));
  put(31u, pelage_resolve(pelage_add_tail(pixel, tail), colour));
  put(34u, pelage_transmittance_of(f(8u)));
  put(35u, pelage_clamp_keeping_hue(vec3(200.0, 1.0, f(9u)) * colour));
  put(38u, pelage_parting_depth(1.0 + colour.x, 1.0 + colour.y));
  pelage_divided_pixel divided = pelage_add_fibre(pelage_empty_divided_pixel(), true, colour, back.xyz, alpha);
  divided = pelage_add_fibre(divided, false, back.xyz, colour, f(7u));
  const pelage_divided_backdrop backdrop = pelage_divided_backdrop(1.0, alpha, alpha * colour, back.xyz);
  put(39u, pelage_resolve(pelage_add_tails(divided, pelage_empty_tail(), tail), backdrop));
  pelage_sliced_tail sliced = pelage_sliced_tail_empty();
  pelage_sliced_tail_add(sliced, 16.0 * back.x, alpha, colour);
  pelage_sliced_tail rest = pelage_sliced_tail_empty();
  pelage_sliced_tail_add(rest, 16.0 * back.y, f(7u), back.xyz);
  pelage_sliced_tail_merge(sliced, rest);
  const pelage_tail slice = sliced.slice[pelage_layer_at(16.0 * back.x, 16u)];
  put(42u, slice.optical);
  put(43u, slice.weight);
  put(44u, slice.red);
  put(45u, slice.green);
  put(46u, slice.blue);
  put(47u, pelage_resolve(pelage_add_sliced_tail(pelage_empty_pixel(), sliced), colour));
}
