// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 16u
#define RESULTS 52u
#include "table.glsl"

#include "pelage/glsl/core/vector_math.glsl"
#include "pelage/glsl/coverage/chord_run.glsl"
#include "pelage/glsl/coverage/closest_points.glsl"
#include "pelage/glsl/coverage/disc_strip.glsl"
#include "pelage/glsl/coverage/joint.glsl"
#include "pelage/glsl/coverage/line_width.glsl"
#include "pelage/glsl/coverage/ray_cone.glsl"
#include "pelage/glsl/coverage/segment_quad.glsl"
#include "pelage/glsl/coverage/strand_share.glsl"

void main() {
  if (outside()) return;
  const vec3 origin = v3(0u);
  const vec3 direction = v3(3u);
  const vec3 start = v3(6u);
  const vec3 end = v3(9u);
  const pelage_closest_pair pair = pelage_closest_points(origin, direction, start, end);
  put(0u, pair.along_ray);
  put(1u, pair.along_segment);
  put(2u, pair.distance);
  put(3u, pelage_offset_across(origin, direction, start, end, pair, 4.0));
  const float radius = f(12u);
  const float disc = f(13u);
  put(4u, pelage_cap_share(f(14u)));
  put(5u, pelage_disc_strip_share(f(14u), radius, disc));
  put(6u, pelage_diagonal_ratio(start.xy));
  put(7u, pelage_line_width_share(start.xy, radius, disc));
  const pelage_ray_cone cone = pelage_perspective_cone(f(15u), 1080, pelage_pixel_footprint_inscribed);
  const pelage_ray_cone cylinder = pelage_orthographic_cone(f(15u), 512, pelage_pixel_footprint_equal_area);
  put(8u, cone.slope);
  put(9u, cylinder.base);
  put(10u, pelage_radius_at(cone, f(14u)));
  put(11u, pelage_reach_at(f(14u), radius, cone, 2.0));
  put(12u, pelage_any_normal(pelage_unit_vector(direction)));
  const pelage_segment_quad quad = pelage_expand_segment(start, end, radius, cone, 0.1, 2.0);
  put(15u, quad.visible);
  put(16u, quad.corner[0]);
  put(19u, quad.corner[1]);
  put(22u, quad.corner[2]);
  put(25u, quad.corner[3]);
  put(28u, cone.base);
  put(29u, cylinder.slope);
  put(30u, pelage_tangent_stretch(0.5 * f(14u)));
  const pelage_strand_joint first = pelage_strand_joint(origin.xy, direction.xy);
  const pelage_strand_joint second = pelage_strand_joint(start.xy, end.xy);
  const vec2 pixel = vec2(f(14u), f(12u));
  put(31u, pelage_past_joint(first, pixel));
  put(32u, pelage_owned_by_segment(first, second, pixel));
  put(33u, pelage_mean_line_width_share(radius, disc));
  const pelage_chord_run begun = pelage_begin_chord(start, radius, 1.0);
  const pelage_chord_run run = pelage_pass_point(begun, end, disc, 0.5, 0.25);
  put(34u, run.along);
  put(37u, run.side);
  put(40u, run.least_slope);
  put(43u, run.greatest_slope);
  put(46u, run.reach);
  put(47u, pelage_chord_reaches(run, end + (end - start) + 0.25 * direction, disc, 0.5));
  put(48u, pelage_screen_tolerance(radius, -start.z, 2.0, 300.0, 1.25));
  put(49u, pelage_kept_share(radius, disc, 0.01));
  put(50u, pelage_width_factor(0.4 * f(14u), pelage_kept_share(radius, disc, 0.01)));
  put(51u, pelage_strand_rank(floatBitsToUint(radius)));
}
