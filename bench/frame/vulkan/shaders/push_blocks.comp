// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The A-buffer of blocks: what a workgroup draws of one pixel goes side by side, to the head of the pixel's list. In:
// points, limits. Out: pool or, of the camera, records; links, seen. One invocation a segment; bounded by the
// arithmetic of walk and coverage, then by the separate stores.
//
// A workgroup's segments lie close together: if all fit a window of the screen, their pixels are counted there, each
// gets its part of one block, and what is drawn is stored at once where it stays. Else each fragment is a block.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "draw.glsl"
#include "lists.glsl"

const uint window_pixels = 2048u;
const uint used_bits = 12u;  ///< a pixel has at most a fragment an invocation at a time

/// Row by row: a pixel's first node in the workgroup's block, above how many of its nodes are in use.
shared uint window[window_pixels];
shared ivec2 lower;
shared ivec2 upper;
shared uint wanted;
shared pelage_unrolled_list_node_block block;

bool has_window;
ivec2 window_size;

uint window_index(ivec2 at) {
  return uint((at.y - lower.y) * window_size.x + at.x - lower.x);
}

void store(uint place, uint i, segment_in_pixel where) {
  const pelage_fragment f = fragment_of(i, where);
  if (is_camera()) {
    records[place] =
        uvec4(floatBitsToUint(f.depth), f.id, floatBitsToUint(where.coverage), floatBitsToUint(where.along));
  } else {
    pool[place] = f;
  }
}

void visit(uint i, uint pixel, segment_in_pixel where) {
  pelage_unrolled_list_node_block mine;
  if (has_window) {
    const int across = VIEW.size.x;
    const uint word = atomicAdd(window[window_index(ivec2(int(pixel) % across, int(pixel) / across))], 1u);
    mine = pelage_unrolled_list_part(block, (word >> used_bits) + (word & ((1u << used_bits) - 1u)), 1u);
  } else {
    mine = pelage_unrolled_list_take(1u);
  }
  if (mine.size == 0u) {
    atomicAdd(reports[this_view()].refused, 1u);
    return;
  }
  store(mine.first, i, where);
  if (!has_window) {
    pelage_unrolled_list_push(pixel, mine);
  }
}

/// The rectangle of the workgroup's cells: [lower, upper).
void find_window(stamp s) {
  if (gl_LocalInvocationIndex == 0u) {
    lower = VIEW.size;
    upper = ivec2(0);
    wanted = 0u;
  }
  barrier();
  ivec2 first = VIEW.size;
  ivec2 end = ivec2(0);
  if (s.cells != uvec2(0u)) {
    const uint either = s.cells.x | s.cells.y;
    const uint folded = either | either >> 16u;
    const uint columns = (folded | folded >> 8u) & 0xffu;
    const int first_bit = s.cells.x != 0u ? findLSB(s.cells.x) : findLSB(s.cells.y) + 32;
    const int last_bit = s.cells.y != 0u ? findMSB(s.cells.y) + 32 : findMSB(s.cells.x);
    const ivec2 corner = pixel_of_cell(s.corner, 0u);
    first = corner + ivec2(findLSB(columns), first_bit / 8);
    end = corner + ivec2(findMSB(columns), last_bit / 8) + 1;
  }
  first = subgroupMin(first);
  end = subgroupMax(end);
  if (subgroupElect()) {
    atomicMin(lower.x, first.x);
    atomicMin(lower.y, first.y);
    atomicMax(upper.x, end.x);
    atomicMax(upper.y, end.y);
  }
  barrier();
}

/// Gives each pixel of the window its part of a block with room for the workgroup's stamps.
void open_window(stamp s) {
  const uint pixels = uint(window_size.x * window_size.y);
  for (uint i = gl_LocalInvocationIndex; i < pixels; i += gl_WorkGroupSize.x) {
    window[i] = 0u;
  }
  barrier();
  while (s.cells != uvec2(0u)) {
    const uint cell = take_cell(s);
    atomicAdd(window[window_index(pixel_of_cell(s.corner, cell))], 1u);
  }
  barrier();
  for (uint from = 0u; from < pixels; from += gl_WorkGroupSize.x) {
    const uint i = from + gl_LocalInvocationIndex;
    const uint room = i < pixels ? window[i] : 0u;
    const uint before = subgroupExclusiveAdd(room);
    const uint all = subgroupAdd(room);
    uint base = 0u;
    if (subgroupElect()) {
      base = atomicAdd(wanted, all);
    }
    if (i < pixels) {
      window[i] = (subgroupBroadcastFirst(base) + before) << used_bits;
    }
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u) {
    block = pelage_unrolled_list_take(wanted);
  }
  barrier();
}

/// Links what each pixel of the window got.
void close_window() {
  const uint pixels = uint(window_size.x * window_size.y);
  barrier();
  for (uint i = gl_LocalInvocationIndex; i < pixels; i += gl_WorkGroupSize.x) {
    const ivec2 at = lower + ivec2(int(i) % window_size.x, int(i) / window_size.x);
    const uint used = window[i] & ((1u << used_bits) - 1u);
    pelage_unrolled_list_push(index_of(at), pelage_unrolled_list_part(block, window[i] >> used_bits, used));
  }
  barrier();
}

void main() {
  const uint number = invocation();
  const bool is_segment = number < scene.segment_count;
  const uint word = is_segment ? segments[number] : begins_strand | ends_strand;
  begin_drawing(word & point_mask);
  pixel_walk w = walk_of(word, own_segment);
  bool more = is_segment;
  for (;;) {
    stamp s = stamp(0u, uvec2(0u));
    if (more) {
      s = next_stamp(w);
      more = s.cells != uvec2(0u);
    }
    find_window(s);
    window_size = upper - lower;
    if (window_size.x <= 0) {
      break;
    }
    has_window = uint(window_size.x) * uint(window_size.y) <= window_pixels;
    if (has_window) {
      open_window(s);
    }
    if (subgroupAny(s.cells != uvec2(0u))) {
      draw_stamp(s);
    }
    if (has_window) {
      close_window();
    } else {
      barrier();
    }
  }
  end_drawing();
}
