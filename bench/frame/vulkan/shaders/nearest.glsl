// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The K nearest fragments of a run, found by a whole subgroup: a K-buffer with a slot a lane, sorted at all times.
//
// The run is read a subgroup at a time. What is nearer than the K-th so far is inserted, one fragment after another
// where they are few: every slot behind the place takes its neighbour's. Where they are many, the subgroup sorts them
// by Batcher's bitonic network and merges them into the slots. The result depends on the set of fragments alone.
#ifndef PELAGE_FRAME_NEAREST_GLSL
#define PELAGE_FRAME_NEAREST_GLSL
#include "scene.glsl"
#include "subgroup.glsl"

const uint rows = (uint(K) + lanes - 1u) / lanes;

/// Above so many a sort and a merge cost less than insertions.
const uint most_insertions = 8u;

/// Slot number row * lanes + lane, nearest first; what lies from slot K on means nothing. Key of the depth, and id.
uvec2 nearest[rows];

const uvec2 none = uvec2(0xffffffffu);

uvec2 key_of(pelage_fragment f) {
  return uvec2(pelage_depth_key(f.depth), f.id);
}

pelage_fragment fragment_from(uvec2 key) {
  return pelage_fragment(pelage_depth_from_key(key.x), key.y);
}

bool key_before(uvec2 a, uvec2 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// The pixel that this subgroup works at, of all its view's.
ivec2 pixel_of_subgroup() {
  const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return pixel_of(group * gl_NumSubgroups + gl_SubgroupID);
}

/// One step of the network: this lane's and its partner's in order, the nearer in the lane whose bit is not set.
uvec2 order_with(uvec2 mine, uint stride, bool nearer) {
  const uvec2 other = subgroupShuffleXor(mine, stride);
  const bool swap = nearer ? key_before(other, mine) : key_before(mine, other);
  return swap ? other : mine;
}

/// A bitonic sequence sorted.
uvec2 clean(uvec2 mine) {
  for (uint stride = lanes / 2u; stride > 0u; stride /= 2u) {
    mine = order_with(mine, stride, (gl_SubgroupInvocationID & stride) == 0u);
  }
  return mine;
}

uvec2 sorted(uvec2 mine) {
  for (uint size = 2u; size <= lanes; size *= 2u) {
    for (uint stride = size / 2u; stride > 0u; stride /= 2u) {
      const bool upward = (gl_SubgroupInvocationID & size) == 0u;
      mine = order_with(mine, stride, ((gl_SubgroupInvocationID & stride) == 0u) == upward);
    }
  }
  return mine;
}

/// Takes one fragment in, the same in all lanes.
void insert(uvec2 offered) {
  for (uint row = rows; row-- > 0u;) {
    const uvec2 last = row > 0u ? subgroupBroadcast(nearest[max(row, 1u) - 1u], lanes - 1u) : uvec2(0u);
    const uvec2 left = subgroupShuffleUp(nearest[row], 1u);
    const uvec2 before = gl_SubgroupInvocationID == 0u ? last : left;
    const bool is_first = row == 0u && gl_SubgroupInvocationID == 0u;
    if (key_before(offered, nearest[row])) {
      nearest[row] = is_first || !key_before(offered, before) ? offered : before;
    }
  }
}

/// Takes one fragment a lane in.
void merge(uvec2 offered) {
  uvec2 carried = sorted(offered);
  for (uint row = 0u; row < rows; ++row) {
    const uvec2 other = subgroupShuffle(carried, lanes - 1u - gl_SubgroupInvocationID);
    const bool swap = key_before(other, nearest[row]);
    const uvec2 far = swap ? nearest[row] : other;
    nearest[row] = clean(swap ? other : nearest[row]);
    carried = clean(far);
  }
}

/// The slot of a fragment that is in one.
uint slot_of(uvec2 held) {
  uint begin = 0u;
  for (uint step = rows * lanes / 2u; step > 0u; step /= 2u) {
    // The last slot of the lower half, from whichever row it lies in.
    const uint last = begin + step - 1u;
    uvec2 there = subgroupShuffle(nearest[0], last % lanes);
    for (uint row = 1u; row < rows; ++row) {
      const uvec2 other = subgroupShuffle(nearest[row], last % lanes);
      there = row == last / lanes ? other : there;
    }
    begin += key_before(there, held) ? step : 0u;
  }
  return begin;
}

uvec2 kth() {
  return subgroupBroadcast(nearest[(uint(K) - 1u) / lanes], (uint(K) - 1u) % lanes);
}

/// Where the fragments of runs lie is the including shader's choice.
pelage_fragment offered_at(uint i);

/// Fills the slots with the nearest of the run [begin, end).
void select_nearest(uint begin, uint end) {
  for (uint row = 0u; row < rows; ++row) {
    nearest[row] = none;
  }
  uint i = begin + gl_SubgroupInvocationID;
  uvec2 next = i < end ? key_of(offered_at(i)) : none;
  for (uint from = begin; from < end; from += lanes) {
    const uvec2 mine = next;
    i += lanes;
    next = i < end ? key_of(offered_at(i)) : none;  // on its way while these are put in order
    bool waiting = key_before(mine, kth());
    uvec4 ballot = subgroupBallot(waiting);
    if (subgroupBallotBitCount(ballot) > most_insertions) {
      merge(waiting ? mine : none);
    } else {
      while (ballot != uvec4(0u)) {
        const uint lane = subgroupBallotFindLSB(ballot);
        insert(subgroupShuffle(mine, lane));
        waiting = waiting && gl_SubgroupInvocationID != lane;
        ballot = subgroupBallot(waiting);
      }
    }
  }
}

#endif
