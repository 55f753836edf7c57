// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Finds the pixels that each segment may touch, and counts for each pixel the fragments that it can have at most. In:
// points, limits of blocks. Out: counts; stamps, a segment's first at its own place and more behind those of all. One
// invocation a segment; bounded by the walk's arithmetic.
//
// A workgroup's segments lie close together: if all fit a window of the screen they are counted there, and added to the
// counts once a pixel (on an H100 an add a fragment took as long as all the rest).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "stamps.glsl"

const uint window_pixels = 1024u;

shared uint window[window_pixels];  ///< counts, row by row
shared ivec2 lower;
shared ivec2 upper;

void count_cells(stamp s) {
  while (s.cells != uvec2(0u)) {
    const uint cell = take_cell(s);
    atomicAdd(counts[VIEW.first_pixel + index_of(pixel_of_cell(s.corner, cell))], 1u);
  }
}

void count_in_window(stamp s, int across) {
  while (s.cells != uvec2(0u)) {
    const uint cell = take_cell(s);
    const ivec2 at = pixel_of_cell(s.corner, cell) - lower;
    atomicAdd(window[at.y * across + at.x], 1u);
  }
}

/// Counts the workgroup's stamps. Every invocation calls it.
void count_together(stamp s) {
  if (gl_LocalInvocationIndex == 0u) {
    lower = VIEW.size;
    upper = ivec2(0);
  }
  barrier();
  if (s.cells != uvec2(0u)) {
    const ivec2 corner = pixel_of_cell(s.corner, 0u);
    atomicMin(lower.x, corner.x);
    atomicMin(lower.y, corner.y);
    atomicMax(upper.x, corner.x + stamp_side);
    atomicMax(upper.y, corner.y + stamp_side);
  }
  barrier();
  const ivec2 size = max(upper - lower, ivec2(0));
  const uint pixels = uint(size.x) * uint(size.y);
  if (pixels > window_pixels) {
    count_cells(s);
    return;
  }
  for (uint i = gl_LocalInvocationIndex; i < pixels; i += gl_WorkGroupSize.x) {
    window[i] = 0u;
  }
  barrier();
  count_in_window(s, size.x);
  barrier();
  for (uint i = gl_LocalInvocationIndex; i < pixels; i += gl_WorkGroupSize.x) {
    if (window[i] > 0u) {
      const ivec2 at = lower + ivec2(int(i) % size.x, int(i) / size.x);
      atomicAdd(counts[VIEW.first_pixel + index_of(at)], window[i]);
    }
  }
}

void main() {
  const uint number = invocation();
  const bool is_segment = number < scene.segment_count;
  const uint word = is_segment ? segments[number] : begins_strand | ends_strand;
  pixel_walk w = walk_of(word, place(word & point_mask));
  stamp s = stamp(0u, uvec2(0u));
  if (is_segment) {
    s = next_stamp(w);
    put_stamp(number, word & point_mask, s);
  }
  count_together(s);
  while (s.cells != uvec2(0u)) {
    s = next_stamp(w);
    if (s.cells != uvec2(0u)) {
      put_stamp(scene.segment_count + atomicAdd(reports[this_view()].stamps, 1u), word & point_mask, s);
      count_cells(s);
    }
  }
}
