// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The K nearest fragments of a run, found by a whole subgroup: a K-buffer with a slot a lane, sorted at all times.
//
// The run is read twice. First each lane takes the least depth of those that it reads: the K-th least of these bounds
// the K nearest, and few fragments lie within it (about 1.4 K of however many). Then those are gathered until there is
// one for each lane, sorted by Batcher's bitonic network and merged into the slots. The result depends on the set of
// fragments alone.
#ifndef PELAGE_FRAME_NEAREST_GLSL
#define PELAGE_FRAME_NEAREST_GLSL
#include "scene.glsl"
#include "subgroup.glsl"

const uint rows = (uint(K) + lanes - 1u) / lanes;

/// Slot number row * lanes + lane, nearest first; what lies from slot K on means nothing. Key of the depth, id, and the
/// fragment's place in the pool.
uvec3 nearest[rows];

const uvec3 none = uvec3(0xffffffffu);

/// Fragments within the bound that wait to be merged.
shared uvec3 gathered[2u * gl_WorkGroupSize.x];

bool key_before(uvec3 a, uvec3 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// The pixel that this subgroup works at, of all its view's.
ivec2 pixel_of_subgroup() {
  const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return pixel_of(group * gl_NumSubgroups + gl_SubgroupID);
}

/// One step of the network: this lane's and its partner's in order, the nearer in the lane whose bit is not set.
uvec3 order_with(uvec3 mine, uint stride, bool nearer) {
  const uvec3 other = subgroupShuffleXor(mine, stride);
  const bool swap = nearer ? key_before(other, mine) : key_before(mine, other);
  return swap ? other : mine;
}

/// A bitonic sequence sorted.
uvec3 clean(uvec3 mine) {
  for (uint stride = lanes / 2u; stride > 0u; stride /= 2u) {
    mine = order_with(mine, stride, (gl_SubgroupInvocationID & stride) == 0u);
  }
  return mine;
}

bool is_lower_of(uint size, uint stride) {
  return ((gl_SubgroupInvocationID & stride) == 0u) == ((gl_SubgroupInvocationID & size) == 0u);
}

uvec3 sorted(uvec3 mine) {
  for (uint size = 2u; size <= lanes; size *= 2u) {
    for (uint stride = size / 2u; stride > 0u; stride /= 2u) {
      mine = order_with(mine, stride, is_lower_of(size, stride));
    }
  }
  return mine;
}

uint sorted_numbers(uint mine) {
  for (uint size = 2u; size <= lanes; size *= 2u) {
    for (uint stride = size / 2u; stride > 0u; stride /= 2u) {
      const uint other = subgroupShuffleXor(mine, stride);
      mine = is_lower_of(size, stride) ? min(mine, other) : max(mine, other);
    }
  }
  return mine;
}

/// Takes one fragment a lane in.
void merge(uvec3 offered) {
  uvec3 carried = sorted(offered);
  for (uint row = 0u; row < rows; ++row) {
    const uvec3 other = subgroupShuffle(carried, lanes - 1u - gl_SubgroupInvocationID);
    const bool swap = key_before(other, nearest[row]);
    const uvec3 far = swap ? nearest[row] : other;
    nearest[row] = clean(swap ? other : nearest[row]);
    carried = clean(far);
  }
}

/// The fragment in a slot, the same number in all lanes.
uvec3 in_slot(uint slot) {
  uvec3 found = none;
  for (uint row = 0u; row < rows; ++row) {
    const uvec3 there = subgroupShuffle(nearest[row], slot % lanes);
    found = row == slot / lanes ? there : found;
  }
  return found;
}

// The including shader says where the fragments of runs lie, and what it does with each when it is first read.
pelage_fragment offered_at(uint i);
void look_at(pelage_fragment f);

/// Looks at the run, and bounds what may be among the K nearest.
uvec3 bound_of(uint begin, uint end) {
  uint least = 0xffffffffu;
  for (uint i = begin + gl_SubgroupInvocationID; i < end; i += lanes) {
    const pelage_fragment f = offered_at(i);
    least = min(least, pelage_depth_key(f.depth));
    look_at(f);
  }
  const bool is_bound = 2u * uint(K) <= lanes && end - begin > lanes;
  if (!is_bound) {
    return none;
  }
  return uvec3(subgroupBroadcast(sorted_numbers(least), min(uint(K), lanes) - 1u), 0xffffffffu, 0u);
}

/// Fills the slots with the nearest of the run [begin, end).
void select_nearest(uint begin, uint end) {
  for (uint row = 0u; row < rows; ++row) {
    nearest[row] = none;
  }
  uvec3 bound = bound_of(begin, end);
  const uint first = 2u * lanes * gl_SubgroupID;
  uint waiting = 0u;
  for (uint from = begin; from < end; from += lanes) {
    const uint i = from + gl_SubgroupInvocationID;
    const pelage_fragment f = offered_at(min(i, end - 1u));
    const uvec3 mine = uvec3(pelage_depth_key(f.depth), f.id, i);
    const bool is_near = i < end && !key_before(bound, mine);
    const uvec4 near = subgroupBallot(is_near);
    if (is_near) {
      gathered[first + waiting + subgroupBallotExclusiveBitCount(near)] = mine;
    }
    waiting += subgroupBallotBitCount(near);
    subgroupMemoryBarrierShared();
    subgroupBarrier();
    if (waiting >= lanes) {
      waiting -= lanes;
      merge(gathered[first + waiting + gl_SubgroupInvocationID]);
      const uvec3 last = in_slot(uint(K) - 1u);
      bound = key_before(last, bound) ? last : bound;
      subgroupBarrier();
    }
  }
  if (waiting > 0u) {
    const uvec3 mine = gathered[first + min(gl_SubgroupInvocationID, waiting - 1u)];
    merge(gl_SubgroupInvocationID < waiting ? mine : none);
  }
}

#endif
