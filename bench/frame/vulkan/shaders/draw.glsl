// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Draws a subgroup's segments together: the pixels of their stamps are queued, and whenever there is one for each lane,
// all lanes compute coverage at once, each of whichever segment. The including shader says what becomes of a fragment
// of the segment that begins at point i:
//   void visit(uint i, uint pixel, segment_in_pixel where)
// and, where that is known by an earlier pass (SEEN_BEFORE), does not ask which segments the camera sees.
#ifndef PELAGE_FRAME_DRAW_GLSL
#define PELAGE_FRAME_DRAW_GLSL
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_vote : require
#include "fragments.glsl"
#include "subgroup.glsl"
#include "walk.glsl"

void visit(uint i, uint pixel, segment_in_pixel where);

shared uint queue[2u * gl_WorkGroupSize.x];  ///< the lane that has the stamp, and the cell
shared uint has_fragment[gl_WorkGroupSize.x];

placed_segment own_segment;
uint own_point;
vec2 own_opacity;

/// Visits the fragment of one queue entry a lane, if there is one. All lanes call it together.
void draw_queued(stamp own, uint entry, bool is_entry) {
  const uint lane = queue[entry] / 64u;
  const placed_segment s =
      placed_segment(subgroupShuffle(own_segment.start, lane), subgroupShuffle(own_segment.end, lane),
                     subgroupShuffle(own_segment.start_radius, lane), subgroupShuffle(own_segment.end_radius, lane));
  const uint corner = subgroupShuffle(own.corner, lane);
  const uint i = subgroupShuffle(own_point, lane);
  drawn_opacity = subgroupShuffle(own_opacity, lane);
  if (is_entry) {
    const ivec2 at = pixel_of_cell(corner, queue[entry] % 64u);
    const uint pixel = index_of(at);
    const segment_in_pixel where = look_at(s, at);
    if (is_fragment(where, pixel)) {
      has_fragment[gl_SubgroupID * lanes + lane] = 1u;
      visit(i, pixel, where);
    }
  }
}

const uint no_row = 0xffffffffu;

/// The row of the screen that a stamp's first cell lies in.
uint next_row(stamp s) {
  if (s.cells == uvec2(0u)) {
    return no_row;
  }
  const uint cell = s.cells.x != 0u ? uint(findLSB(s.cells.x)) : uint(findLSB(s.cells.y)) + 32u;
  return (s.corner >> 16u) + cell / 8u;
}

/// Draws each lane's stamp, row by row of the screen: a pixel's fragments come together, and what goes to
/// places side by side is stored at once. All lanes call it together.
void draw_stamp(stamp s) {
  const uint first = 2u * gl_SubgroupID * lanes;
  uint queued = 0u;
  for (;;) {
    const uint row = next_row(s);
    const uint next = subgroupMin(row);
    if (next == no_row) {
      break;
    }
    const bool is_next = row == next;
    const uvec4 found = subgroupBallot(is_next);
    if (is_next) {
      queue[first + queued + subgroupBallotExclusiveBitCount(found)] = 64u * gl_SubgroupInvocationID + take_cell(s);
    }
    queued += subgroupBallotBitCount(found);
    subgroupMemoryBarrierShared();
    subgroupBarrier();
    if (queued >= lanes) {
      queued -= lanes;
      draw_queued(s, first + queued + gl_SubgroupInvocationID, true);
      subgroupBarrier();
    }
  }
  draw_queued(s, first + min(gl_SubgroupInvocationID, max(queued, 1u) - 1u), gl_SubgroupInvocationID < queued);
  subgroupBarrier();
}

/// Makes the segment that begins at a point this lane's.
void begin_drawing(uint point) {
  own_point = point;
  own_segment = place(point);
  own_opacity = opacity_of(point);
  has_fragment[gl_SubgroupID * lanes + gl_SubgroupInvocationID] = 0u;
}

/// Says for the camera which segments are seen.
void end_drawing() {
#ifndef SEEN_BEFORE
  subgroupMemoryBarrierShared();
  subgroupBarrier();
  if (is_camera() && has_fragment[gl_SubgroupID * lanes + gl_SubgroupInvocationID] != 0u) {
    seen[own_point] = 1u;
  }
#endif
}

/// Draws this invocation's segment, as it is numbered; of the slice alone (SLICED). Every invocation calls it.
void draw_segments() {
#ifdef SLICED
  const uint number = push.first_segment + invocation();
  const bool is_segment = number < push.end_segment;
#else
  const uint number = invocation();
  const bool is_segment = number < scene.segment_count;
#endif
  const uint word = is_segment ? segments[number] : begins_strand | ends_strand;
  begin_drawing(word & point_mask);
  pixel_walk w = walk_of(word, own_segment);
  bool more = is_segment;
  while (subgroupAny(more)) {
    stamp s = stamp(0u, uvec2(0u));
    if (more) {
      s = next_stamp(w);
      more = s.cells != uvec2(0u);
    }
    draw_stamp(s);
  }
  end_drawing();
}

#endif
