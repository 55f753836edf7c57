// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The weighted sums of the camera's pixels, before an object's edge and behind it: weight, and weight times radiance,
// in the units of a tail. Its optical depth (or number) is what the pixel's map holds; what of that lies behind the edge
// is summed as well. Not pelage_atomic_tail: 36 bytes a pixel in place of 48, the ends of the sums marked in the map
// behind those of its own, and all adds on their way before the first answer is waited for.
#ifndef PELAGE_FRAME_SUMS_GLSL
#define PELAGE_FRAME_SUMS_GLSL
#include "pelage/glsl/composite/divided_pixel.glsl"
#include "pelage/glsl/composite/weighted_average.glsl"
#include "pelage/glsl/composite/weighted_sum.glsl"
#include "pixel_map.glsl"

layout(std430, binding = 21) buffer sum_buffer { uint sums[]; };

const uint optical_behind = 8u;  ///< the last of a pixel's sums; four before the edge and four behind it come first

/// The four before the edge lie together, of all pixels; what lies behind an edge is rare.
uint place_of_sum(uint pixel, uint i) {
  return i < 4u ? 4u * pixel + i : 4u * uint(VIEW.size.x * VIEW.size.y) + 5u * pixel + (i - 4u);
}

/// What lies deep adds nothing.
void add_to_sums(uint pixel, uint texel, bool is_before_edge, pelage_tail one) {
  const uvec4 part = uvec4(one.weight, one.red, one.green, one.blue);
  const uint first = is_before_edge ? 0u : 4u;
  if (!is_before_edge && atomicAdd(sums[place_of_sum(pixel, optical_behind)], one.optical) > 0xffffffffu - one.optical) {
    mark_end(texel, optical_behind);
  }
  if (part == uvec4(0u)) {
    return;
  }
  uvec4 held;
  for (uint i = 0u; i < 4u; ++i) {
    held[i] = atomicAdd(sums[place_of_sum(pixel, first + i)], part[i]);
  }
  const bvec4 passes = greaterThan(held, 0xffffffffu - part);
  if (any(passes)) {
    for (uint i = 0u; i < 4u; ++i) {
      if (passes[i]) {
        mark_end(texel, first + i);
      }
    }
  }
}

uint load_sum(uint pixel, uint passed, uint i) {
  return (passed >> i & 1u) != 0u ? 0xffffffffu : sums[place_of_sum(pixel, i)];
}

#if defined(AVERAGE)
/// What equal fragments, as many as the tail holds in the place of their optical depth, make of a pixel.
pelage_pixel_radiance part_of(pelage_tail sums) {
  const pelage_weighted_average all = pelage_weighted_average(sums, sums.optical);
  return pelage_pixel_radiance(pelage_weighted_average_resolve(all, vec3(0.0)),
                               vec3(pelage_weighted_average_transmittance(all)));
}
#elif defined(UNSCALED)
pelage_pixel_radiance part_of(pelage_tail sums) {
  return pelage_pixel_radiance(pelage_resolve_unscaled(sums, vec3(0.0)), vec3(pelage_transmittance_of(sums)));
}
#endif

pelage_divided_pixel seen_of(pelage_tail before, pelage_tail behind) {
#if defined(AVERAGE) || defined(UNSCALED)
  return pelage_divided_pixel(part_of(before), part_of(pelage_merge(before, behind)));
#else
  return pelage_add_tails(pelage_empty_divided_pixel(), before, behind);
#endif
}

/// What is seen of a pixel by its sums, before and behind the edge: in its near part by the former, else by both.
pelage_divided_pixel load_sums(uint pixel, uint texel) {
  const uint passed = passed_ends(texel);
  uint sum[9];
  for (uint i = 0u; i < 9u; ++i) {
    sum[i] = load_sum(pixel, passed, i);
  }
  const uint total = total_of(texel);
  const uint behind = min(sum[optical_behind], total);
  return seen_of(pelage_tail(total - behind, sum[0], sum[1], sum[2], sum[3]),
                 pelage_tail(behind, sum[4], sum[5], sum[6], sum[7]));
}

#endif
