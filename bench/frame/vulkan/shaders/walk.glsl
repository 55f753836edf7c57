// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The pixels that a segment may touch, by the screen alone: a superset of those that it does touch, about a fifth more.
//
// They come as stamps, 8 × 8 pixels each, most segments' all in one. Pixels are walked along the longer side of the
// screen's rectangle round the axis, column by column, and in each those whose centres lie within the fibre's reach
// beside the axis and between the joints' lines.
#ifndef PELAGE_FRAME_WALK_GLSL
#define PELAGE_FRAME_WALK_GLSL
#include "raster.glsl"

#ifdef PASSES_OVER
/// The including shader's choice: true if no fragment between two depths of a pixel matters.
bool passes_over(uint pixel, float least_depth, float most_depth);
#else
#define passes_over(pixel, least_depth, most_depth) false
#endif

const int stamp_side = 8;

/// Pixels of a square that a segment may touch.
struct stamp {
  uint corner;  ///< of the square, x in the low half, y in the high
  uvec2 cells;  ///< a bit a pixel, row by row; 0: there is none
};

/// Takes the first of a stamp's cells out, of one that has any.
uint take_cell(inout stamp s) {
  const bool low = s.cells.x != 0u;
  const uint half_cells = low ? s.cells.x : s.cells.y;
  const uint left = half_cells & (half_cells - 1u);
  s.cells = low ? uvec2(left, s.cells.y) : uvec2(0u, left);
  return uint(findLSB(half_cells)) + (low ? 0u : 32u);
}

ivec2 pixel_of_cell(uint corner, uint cell) {
  return ivec2((corner & 0xffffu) + cell % 8u, (corner >> 16u) + cell / 8u);
}

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
  int column;         ///< the first of the stamps' columns
  int last;
  int row;  ///< the next stamp's first
  int last_row;
};

/// How far past a joint the pixels on the segment's side of its line lie along the walk, in shares of the reach: the
/// line leans by the walk's angle with the axis and the axis's angle with the strand.
float past_joint(vec2 axis, vec2 strand, float sine, float cosine) {
  const float along = dot(axis, strand);
  const float across = abs(axis.x * strand.y - axis.y * strand.x);
  return along > across ? min(sine + cosine * across / along, 1.0) : 1.0;
}

/// Whether opaque objects hide all that is no nearer than a depth and lies in a rectangle of the screen.
bool is_hidden(vec2 lower, vec2 upper, float least_depth) {
  const ivec2 end = (VIEW.size - 1) / block_side;
  const ivec2 from = ivec2(clamp(lower / float(block_side), vec2(0.0), vec2(end)));
  const ivec2 to = ivec2(clamp(upper / float(block_side), vec2(0.0), vec2(end)));
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      if (!(least_depth >= uintBitsToFloat(block_limits[VIEW.first_block + block_index(ivec2(x, y))]))) {
        return false;
      }
    }
  }
  return true;
}

/// An empty walk for a segment before the near plane, and for one that opaque objects hide.
pixel_walk walk_of(uint word, placed_segment s) {
  const uint i = word & point_mask;
  const vec2 start = to_pixel(this_view(), s.start);
  const vec2 end = to_pixel(this_view(), s.end);
  const float near_depth = min(-s.start.z, -s.end.z);
  const float widest = max(s.start_radius, s.end_radius);
  const bool bounded = near_depth >= VIEW.near_plane;  // else the segment may be anywhere
  const float scale = VIEW.perspective ? VIEW.scale / near_depth : VIEW.scale;
  const float disc = (VIEW.cone_base + VIEW.cone_slope) * VIEW.scale;
  const float reach = bounded ? VIEW.reach * (widest * scale + disc) + 0.01 : 1e9;
  // No ray is nearer to the axis than the nearest end by more than fibre and disc are wide.
  const float far_depth = max(-s.start.z, -s.end.z);
  const float least_depth = near_depth - 2.0 * (widest + pelage_radius_at(cone_of(this_view()), near_depth));
  const float most_depth = far_depth + 2.0 * (widest + pelage_radius_at(cone_of(this_view()), far_depth));

  pixel_walk w;
  w.least_depth = least_depth;
  w.most_depth = most_depth;
  w.last = -1;
  w.column = 0;
  w.row = 0;
  w.last_row = -1;
  if (far_depth < VIEW.near_plane ||
      is_hidden(min(start, end) - reach, max(start, end) + reach, least_depth)) {
    return w;
  }
  const vec2 before =
      (word & begins_strand) != 0u ? start : to_pixel(this_view(), to_view(this_view(), points[i - 1u].xyz));
  const vec2 after = (word & ends_strand) != 0u ? end : to_pixel(this_view(), to_view(this_view(), points[i + 2u].xyz));
  const vec2 start_strand = end - before;
  const vec2 end_strand = after - start;
  const vec2 axis = end - start;
  w.start = line_at(start, start_strand);
  w.end = line_at(end, end_strand);
  w.end_on = draws_lines || (start_strand == vec2(0.0) && end_strand == vec2(0.0));
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
  const float start_past = reach * past_joint(axis, start_strand, sine, cosine);
  const float end_past = reach * past_joint(axis, end_strand, sine, cosine);
  const float left = w.origin.x + min(way.x, 0.0) - (way.x < 0.0 ? end_past : start_past);
  const float right = w.origin.x + max(way.x, 0.0) + (way.x < 0.0 ? start_past : end_past);
  w.column = int(ceil(clamp(left - 0.5, 0.0, size))) - stamp_side;
  w.last = int(floor(clamp(right - 0.5, -1.0, size - 1.0)));
  return w;
}

/// The rows of a column whose centres lie within reach of the axis, from x to y.
ivec2 rows_of(pixel_walk w, int column) {
  const float height = w.upright ? float(VIEW.size.x) : float(VIEW.size.y);
  const float middle = w.origin.y + (float(column) + 0.5 - w.origin.x) * w.slope - 0.5;
  return ivec2(ceil(clamp(middle - w.half_height, 0.0, height)),
               floor(clamp(middle + w.half_height, -1.0, height - 1.0)));
}

/// Goes to the next square of columns and rows. False at the end.
bool next_square(inout pixel_walk w) {
  w.row += stamp_side;
  while (w.row > w.last_row) {
    w.column += stamp_side;
    if (w.column > w.last) {
      return false;
    }
    const ivec2 first = rows_of(w, w.column);
    const ivec2 last = rows_of(w, min(w.column + stamp_side - 1, w.last));
    w.row = min(first.x, last.x);
    w.last_row = max(first.y, last.y);
  }
  return true;
}

/// The next stamp that has a cell; one of none at the end.
stamp next_stamp(inout pixel_walk w) {
  stamp s = stamp(0u, uvec2(0u));
  while (s.cells == uvec2(0u) && next_square(w)) {
    const ivec2 corner = w.upright ? ivec2(w.row, w.column) : ivec2(w.column, w.row);
    s.corner = uint(corner.x) | uint(corner.y) << 16u;
    const int end = min(w.column + stamp_side - 1, w.last);
    for (int column = w.column; column <= end; ++column) {
      const ivec2 rows = rows_of(w, column);
      const int last_row = min(rows.y, w.row + stamp_side - 1);
      for (int row = max(rows.x, w.row); row <= last_row; ++row) {
        const ivec2 at = w.upright ? ivec2(row, column) : ivec2(column, row);
        const vec2 centre = vec2(at) + 0.5;
        const bool is_inside = (is_past(w.start, centre) && !is_past(w.end, centre)) || w.end_on;
        if (is_inside && !passes_over(index_of(at), w.least_depth, w.most_depth)) {
          const uint cell = uint(8 * (at.y - corner.y) + at.x - corner.x);
          s.cells |= uvec2(cell < 32u ? 1u << cell : 0u, cell < 32u ? 0u : 1u << (cell - 32u));
        }
      }
    }
  }
  return s;
}

#endif
