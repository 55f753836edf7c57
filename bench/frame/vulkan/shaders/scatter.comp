// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Puts each fragment into its pixel's run. In: the first free places in counts. Out: pool, or with RECORDS the
// fragments and what they cover to records; seen. One invocation a segment; bounded by the arithmetic of coverage, then
// by 8 or 16 bytes to a place of its own a fragment (on an H100 two thirds and one third; adding is free).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "draw.glsl"

#ifdef RECORDS
#define STORED uvec4
#define STORE(place, what) records[place] = what
#else
#define STORED pelage_fragment
#define STORE(place, what) pool[place] = what
#endif

// A fragment is stored when the next one has asked for its place: the answer takes as long as a fragment's arithmetic.
uint waiting_place;
STORED waiting;
bool is_waiting = false;

void store_waiting() {
  if (is_waiting && waiting_place < push.capacity) {
    STORE(waiting_place, waiting);
  } else if (is_waiting) {
    atomicAdd(reports[push.view].refused, 1u);
  }
}

void visit(uint i, uint pixel, touch where) {
  const uint place = atomicAdd(counts[pixel], 1u);
  store_waiting();
  waiting_place = place;
  is_waiting = true;
#ifdef RECORDS
  waiting = uvec4(floatBitsToUint(where.depth), i, floatBitsToUint(where.coverage), floatBitsToUint(where.along));
#else
  waiting = fragment_of(i, where);
#endif
}

void main() {
  draw_segments();
  store_waiting();
}
