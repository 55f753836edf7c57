// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Draws this invocation's segment together with its subgroup's: pixels that segments may touch are queued, and whenever
// there is one for each lane, all lanes compute coverage at once, each of whichever segment. The including shader says
// what becomes of a fragment of the segment that begins at point i:
//   void visit(uint i, uint pixel, touch where)
// and, where that is known by an earlier pass (SEEN_BEFORE), does not ask which segments the camera sees.
#ifndef PELAGE_FRAME_DRAW_GLSL
#define PELAGE_FRAME_DRAW_GLSL
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_vote : require
#include "subgroup.glsl"
#include "walk.glsl"

void visit(uint i, uint pixel, touch where);

shared uvec2 queue[2u * gl_WorkGroupSize.x];  ///< pixel, and the lane of the segment
shared uint has_fragment[gl_WorkGroupSize.x];

placed_segment own_segment;
uint own_point;
vec2 own_opacity;    ///< at the segment's ends
vec2 drawn_opacity;  ///< of the segment whose fragment is visited

/// What is kept of a fragment in the view: the camera's is found again by its segment's first point, a number that
/// orders as the segment's; a light needs the optical depth alone, and fragments that have depth and optical depth in
/// common are alike.
precise pelage_fragment fragment_of(uint i, touch where) {
  if (is_camera()) {
    return pelage_fragment(where.depth, i);
  }
  const float opacity = drawn_opacity.x + where.along * (drawn_opacity.y - drawn_opacity.x);
  return pelage_fragment(where.depth, pelage_optical_depth(opacity * where.coverage));
}

/// Visits the fragment of one queue entry a lane, if there is one. All lanes call it together.
void draw_queued(uint entry, bool is_entry) {
  const uvec2 queued = queue[entry];
  const uint lane = queued.y;
  const placed_segment s =
      placed_segment(subgroupShuffle(own_segment.start, lane), subgroupShuffle(own_segment.end, lane),
                     subgroupShuffle(own_segment.start_radius, lane), subgroupShuffle(own_segment.end_radius, lane));
  const uint i = subgroupShuffle(own_point, lane);
  drawn_opacity = subgroupShuffle(own_opacity, lane);
  if (is_entry) {
    const ivec2 at = ivec2(queued.x & 0xffffu, queued.x >> 16u);
    const uint pixel = index_of(at);
    const touch where = touch_of(s, at);
    if (where.coverage > 0.0 && !(where.depth >= limits[VIEW.first_pixel + pixel])) {
      has_fragment[gl_SubgroupID * lanes + lane] = 1u;
      visit(i, pixel, where);
    }
  }
}

/// Draws all segments, and says for the camera which are seen. Every invocation calls it.
void draw_segments() {
  const uint number = invocation();
  const bool is_segment = number < scene.segment_count;
  const uint word = is_segment ? segments[number] : begins_strand | ends_strand;
  own_point = word & point_mask;
  own_segment = place(own_point);
  own_opacity = vec2(1.0);
  if (scene.translucent && !is_camera()) {
    own_opacity = vec2(opacities[own_point], opacities[own_point + 1u]);
  }
  const uint mine = gl_SubgroupID * lanes + gl_SubgroupInvocationID;
  const uint first = 2u * gl_SubgroupID * lanes;
  has_fragment[mine] = 0u;

  pixel_walk w = walk_of(word, own_segment);
  bool more = is_segment;
  uint queued = 0u;
  while (subgroupAny(more)) {
    ivec2 at = ivec2(0);
    more = more && next_pixel(w, at);
    const uvec4 found = subgroupBallot(more);
    if (more) {
      queue[first + queued + subgroupBallotExclusiveBitCount(found)] =
          uvec2(uint(at.x) | uint(at.y) << 16u, gl_SubgroupInvocationID);
    }
    queued += subgroupBallotBitCount(found);
    subgroupMemoryBarrierShared();
    subgroupBarrier();
    if (queued >= lanes) {
      queued -= lanes;
      draw_queued(first + queued + gl_SubgroupInvocationID, true);
      subgroupBarrier();
    }
  }
  draw_queued(first + min(gl_SubgroupInvocationID, max(queued, 1u) - 1u), gl_SubgroupInvocationID < queued);
#ifndef SEEN_BEFORE
  if (is_camera()) {
    subgroupMemoryBarrierShared();
    subgroupBarrier();
    if (is_segment) {
      seen[own_point] = has_fragment[mine];
    }
  }
#endif
}

#endif
