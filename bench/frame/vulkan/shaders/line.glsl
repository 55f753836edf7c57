// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A segment drawn as a line, as bench/frame/raster/line_in_pixel.hpp has it. [Svoboda §1.2.3]
#ifndef PELAGE_FRAME_LINE_GLSL
#define PELAGE_FRAME_LINE_GLSL
#include "pelage/glsl/coverage/line_width.glsl"
#include "projection.glsl"

layout(constant_id = 2) const uint primitive = 0u;  ///< 1: segments are lines

const bool draws_lines = primitive == 1u;

/// What a line leaves in a pixel: depth, coverage, place along the segment.
precise vec3 line_in_pixel(vec3 start, vec3 end, float start_radius, float end_radius, ivec2 at, bool smooth_edges) {
  const uint v = this_view();
  const vec2 a = to_pixel(v, start);
  const vec2 b = to_pixel(v, end);
  const float start_depth = -start.z;
  const float end_depth = -end.z;
  const vec2 centre = vec2(at) + 0.5;
  const bool steep = abs(b.y - a.y) > abs(b.x - a.x);
  const float first = steep ? a.y : a.x;
  const float last = steep ? b.y : b.x;
  const float column = steep ? centre.y : centre.x;
  const float beside = steep ? a.x : a.y;
  const float beside_end = steep ? b.x : b.y;
  const float place = (column - first) / (last - first);
  const float offset = (steep ? centre.x : centre.y) - (beside + place * (beside_end - beside));

  const float position = max((max(start_depth, end_depth) - VIEW.line_nearest) / VIEW.line_bin, 0.0);
  const float bin = VIEW.line_bin > 0.0 ? floor(min(position, VIEW.line_last)) : 0.0;
  const float depth_of_bin = VIEW.line_nearest + VIEW.line_bin * bin;
  const float half_width = max(max(start_radius, end_radius) / pixel_at(v, vec3(0.0, 0.0, -depth_of_bin)), 0.5);

  const float along = VIEW.perspective ? place * start_depth / (end_depth + place * (start_depth - end_depth)) : place;
  const float inside = pelage_saturate(along);
  const bool by_depth = VIEW.line_bin > 0.0;
  const vec3 start_at = vec3(0.0, 0.0, by_depth ? start.z : -VIEW.line_nearest);
  const vec3 end_at = vec3(0.0, 0.0, by_depth ? end.z : -VIEW.line_nearest);
  const float near_share = pelage_mean_line_width_share(start_radius, 0.5 * pixel_at(v, start_at));
  const float far_share = pelage_mean_line_width_share(end_radius, 0.5 * pixel_at(v, end_at));
  const float share = smooth_edges ? near_share + inside * (far_share - near_share) : 1.0;

  const bool beside_it = offset >= -half_width && offset < half_width;
  const bool in_its_columns =
      first < last ? column >= first && column < last : first > last && column <= first && column > last;
  const bool in_front = start_depth >= VIEW.near_plane && end_depth >= VIEW.near_plane;
  return vec3(start_depth + inside * (end_depth - start_depth),
              beside_it && in_its_columns && in_front ? share : 0.0, inside);
}

#endif
