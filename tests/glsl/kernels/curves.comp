// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define STRIDE 23u
#define RESULTS 42u
#include "table.glsl"

#include "pelage/glsl/coverage/flatten_curve.glsl"

void main() {
  if (outside()) return;
  const uint basis = u(16u) % 4u;
  const uint wrap = u(17u) % 3u;
  const uint vertices = u(18u) % 20u;
  const uint segment = u(19u) % 20u;
  put(0u, pelage_curve_segments(basis, wrap, vertices));
  put(1u, pelage_varying_values(basis, wrap, vertices));
  put(2u, pelage_varying_at_end(basis, wrap, vertices, segment));
  const pelage_segment_vertices from = pelage_vertices_of_segment(basis, wrap, vertices, segment);
  for (uint k = 0u; k < 4u; ++k) put(3u + k, from.vertex[k]);
  put(7u, from.phantom_start);
  put(8u, from.phantom_end);
  const pelage_bezier_segment curve = pelage_bezier_of(basis, from, vec4[4](v4(0u), v4(4u), v4(8u), v4(12u)));
  for (uint k = 0u; k < 4u; ++k) put(9u + 4u * k, curve.point[k]);
  const uint pieces = pelage_pieces_within(curve, f(20u), f(21u));
  put(25u, pieces);
  put(26u, pelage_piece_error(curve, pieces));
  put(27u, pelage_radius_piece_error(curve, pieces));
  put(28u, pelage_point_of_piece(curve, segment, 19u));
  put(32u, pelage_greatest_piece_length(f(20u), f(21u)));
  put(33u, pelage_error_on_screen(curve, f(20u), f(22u)));
  const pelage_bezier_segment varied = pelage_with_varying(pelage_straight_segment(v4(0u), v4(4u)), f(20u), f(21u));
  put(34u, varied.point[1]);
  put(38u, varied.point[2]);
}
