// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The pixels that a segment may touch, by the screen alone: a superset of those that it does touch, about a fifth more.
//
// Pixels are walked along the longer side of the screen's rectangle round the axis, column by column, and in each those
// whose centres lie within the fibre's reach beside the axis and between the joints' lines.
#ifndef PELAGE_FRAME_WALK_GLSL
#define PELAGE_FRAME_WALK_GLSL
#include "raster.glsl"

#ifdef PASSES_OVER
/// The including shader's choice: true if no fragment between two depths of a pixel matters.
bool passes_over(uint pixel, float least_depth, float most_depth);
#else
#define passes_over(pixel, least_depth, most_depth) false
#endif

/// A line on the screen that divides the pixels between two segments: those past it along the strand are the next's.
struct joint_line {
  vec2 strand;
  float offset;
};

precise joint_line line_at(vec2 joint, vec2 strand) {
  return joint_line(strand, fma(joint.y, strand.y, joint.x * strand.x));
}

/// Both segments that meet at a joint ask the same question, and get the same bits.
precise bool is_past(joint_line line, vec2 centre) {
  const float past = fma(centre.x, line.strand.x, fma(centre.y, line.strand.y, -line.offset));
  return past >= 0.0;
}

struct pixel_walk {
  joint_line start;
  joint_line end;
  bool end_on;       ///< the strand has no direction on the screen: no joints
  bool upright;      ///< columns are the screen's rows
  vec2 origin;       ///< of the axis, x along the walk
  float slope;
  float half_height;  ///< of a column
  float least_depth;  ///< no fragment is nearer
  float most_depth;   ///< nor farther
  int column;
  int last;
  int row;
  int last_row;
};

/// How far past a joint the pixels on the segment's side of its line lie along the walk, in shares of the reach: the
/// line leans by the walk's angle with the axis and the axis's angle with the strand.
float past_joint(vec2 axis, vec2 strand, float sine, float cosine) {
  const float along = dot(axis, strand);
  const float across = abs(axis.x * strand.y - axis.y * strand.x);
  return along > across ? min(sine + cosine * across / along, 1.0) : 1.0;
}

/// An empty walk for a segment before the near plane.
pixel_walk walk_of(uint word, placed_segment s) {
  const uint i = word & point_mask;
  const vec2 start = to_pixel(push.view, s.start);
  const vec2 end = to_pixel(push.view, s.end);
  const vec2 before =
      (word & begins_strand) != 0u ? start : to_pixel(push.view, to_view(push.view, points[i - 1u].xyz));
  const vec2 after = (word & ends_strand) != 0u ? end : to_pixel(push.view, to_view(push.view, points[i + 2u].xyz));
  const vec2 start_strand = end - before;
  const vec2 end_strand = after - start;
  const vec2 axis = end - start;
  const float near_depth = min(-s.start.z, -s.end.z);
  const float widest = max(s.start_radius, s.end_radius);
  const bool bounded = near_depth >= VIEW.near_plane;  // else the segment may be anywhere
  const float scale = VIEW.perspective ? VIEW.scale / near_depth : VIEW.scale;
  const float reach = bounded ? VIEW.reach * (widest * scale + 0.5) + 0.01 : 1e9;

  pixel_walk w;
  w.start = line_at(start, start_strand);
  w.end = line_at(end, end_strand);
  w.end_on = start_strand == vec2(0.0) && end_strand == vec2(0.0);
  w.upright = abs(axis.y) > abs(axis.x);
  w.origin = w.upright ? start.yx : start;
  const vec2 way = w.upright ? axis.yx : axis;
  const float size = w.upright ? float(VIEW.size.y) : float(VIEW.size.x);
  const bool is_point = way.x == 0.0;
  const float per_length = is_point ? 0.0 : inversesqrt(dot(axis, axis));
  const float sine = is_point ? 1.0 : abs(way.y) * per_length;
  const float cosine = abs(way.x) * per_length;
  w.slope = is_point ? 0.0 : way.y / way.x;
  w.half_height = is_point ? reach : reach / cosine;
  // No ray is nearer to the axis than the nearest end by more than fibre and disc are wide.
  w.least_depth = near_depth - 2.0 * (widest + pelage_radius_at(cone_of(push.view), near_depth));
  const float far_depth = max(-s.start.z, -s.end.z);
  w.most_depth = far_depth + 2.0 * (widest + pelage_radius_at(cone_of(push.view), far_depth));
  const float start_past = reach * past_joint(axis, start_strand, sine, cosine);
  const float end_past = reach * past_joint(axis, end_strand, sine, cosine);
  const float left = w.origin.x + min(way.x, 0.0) - (way.x < 0.0 ? end_past : start_past);
  const float right = w.origin.x + max(way.x, 0.0) + (way.x < 0.0 ? start_past : end_past);
  w.column = int(ceil(clamp(left - 0.5, 0.0, size))) - 1;
  w.last = int(floor(clamp(right - 0.5, -1.0, size - 1.0)));
  w.last = far_depth < VIEW.near_plane ? -1 : w.last;
  w.row = 0;
  w.last_row = -1;
  return w;
}

/// Goes to the next pixel that the segment may touch and that is not hidden by opaque objects. False at the end.
bool next_pixel(inout pixel_walk w, out ivec2 at) {
  const float height = w.upright ? float(VIEW.size.x) : float(VIEW.size.y);
  for (;;) {
    if (w.row > w.last_row) {
      if (++w.column > w.last) {
        return false;
      }
      const float middle = w.origin.y + (float(w.column) + 0.5 - w.origin.x) * w.slope - 0.5;
      w.row = int(ceil(clamp(middle - w.half_height, 0.0, height)));
      w.last_row = int(floor(clamp(middle + w.half_height, -1.0, height - 1.0)));
    }
    if (w.row <= w.last_row) {
      at = w.upright ? ivec2(w.row, w.column) : ivec2(w.column, w.row);
      ++w.row;
      const vec2 centre = vec2(at) + 0.5;
      if ((is_past(w.start, centre) && !is_past(w.end, centre)) || w.end_on) {
        const uint pixel = index_of(at);
        if (!(w.least_depth >= limits[VIEW.first_pixel + pixel]) && !passes_over(pixel, w.least_depth, w.most_depth)) {
          return true;
        }
      }
    }
  }
}

#endif
