// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Puts each fragment into its pixel's run. In: stamps, the first free places in counts. Out: pool, or with RECORDS the
// camera's fragments and what they cover to records; seen. One invocation a stamp; bounded by coverage's arithmetic
// and by the number of separate stores (on an H100 as much again; adding is free).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "draw.glsl"
#include "stamps.glsl"

// A fragment is stored when the next one has asked for its place: the answer takes as long as a fragment's arithmetic.
uint waiting_place;
uvec4 waiting_fragment;
bool is_waiting = false;

void store_waiting() {
  if (is_waiting && waiting_place < VIEW.end_place) {
#ifdef RECORDS
    if (is_camera()) {
      records[waiting_place] = waiting_fragment;
      return;
    }
#endif
    pool[waiting_place] = pelage_fragment(uintBitsToFloat(waiting_fragment.x), waiting_fragment.y);
  } else if (is_waiting) {
    atomicAdd(reports[this_view()].refused, 1u);
  }
}

void visit(uint i, uint pixel, segment_in_pixel where) {
  const uint place = atomicAdd(counts[VIEW.first_pixel + pixel], 1u);
  store_waiting();
  waiting_place = place;
  is_waiting = true;
  const pelage_fragment f = fragment_of(i, where);
  waiting_fragment =
      uvec4(floatBitsToUint(f.depth), f.id, floatBitsToUint(where.coverage), floatBitsToUint(where.along));
}

void main() {
  uint point;
  const stamp s = stamp_at(invocation(), point);
  if (subgroupAny(s.cells != uvec2(0u))) {
    begin_drawing(point);
    draw_stamp(s);
    store_waiting();
    end_drawing();
  }
}
