// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A light's map from its runs, or with BLOCKS from lists: the K nearest of each texel with the optical depth up to and
// including each, then the sum, the mean and the farthest depth of the rest. In: runs, counts or links, pool. Out:
// entries, texels. One subgroup a texel; bounded by the sorting networks' shuffles.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#ifdef BLOCKS
#include "block_walk.glsl"
#else
#include "selection.glsl"
#endif
#include "pelage/glsl/composite/optical_depth.glsl"
#include "texel.glsl"

// Of all the run's fragments that this lane reads.
uint low_sum = 0u;
uint high_sum = 0u;
uint moments = 0u;
float farthest = 0.0;
float scale_of_depth;

pelage_fragment fragment_at(uint i) {
  return pool[i];
}

void note(pelage_fragment f) {
  uint carry;
  low_sum = uaddCarry(low_sum, f.id, carry);
  high_sum += carry;
  moments += moment(f, scale_of_depth);
  farthest = max(farthest, f.depth);
}

#ifndef BLOCKS
/// Takes in a pixel's run, and notes what this lane reads of it. How many fragments it has.
uint select_from(uint pixel) {
  const uint begin = runs[pixel].x;
  const uint end = min(counts[pixel], runs[pixel].y);
  pelage_group_select_clear(nearest, uint(K));
  for (uint i = begin + gl_SubgroupInvocationID; i < end; i += lanes) {
    note(pool[i]);
    pelage_group_select_offer_depth(nearest, pool[i]);
  }
  if (end - begin > lanes) {
    pelage_group_select_limit(nearest);
  }
  insert_run(begin, end);
  return end - begin;
}
#endif

/// The optical depth of the whole run less what is kept, clamped to the end of the range.
uint behind(uint kept) {
  const uint low = subgroupAdd(low_sum & 0xffffu);
  const uint middle = subgroupAdd(low_sum >> 16u) + (low >> 16u);
  const uint high = subgroupAdd(high_sum) + (middle >> 16u);
  uint borrow;
  const uint rest = usubBorrow(middle << 16u | (low & 0xffffu), kept, borrow);
  return high > borrow ? 0xffffffffu : rest;
}

void main() {
  const ivec2 at = pixel_of_subgroup();
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = VIEW.first_pixel + index_of(at);
  scale_of_depth = per_far();
#ifdef BLOCKS
  const uint count = select_from(index_of(at));
#else
  const uint count = select_from(pixel);
#endif
  const uint held = pelage_group_select_held(nearest);

  const uint first = pixel * uint(K);
  uint optical = 0u;
  for (uint row = 0u; row < rows; ++row) {
    const uint slot = row * lanes + gl_SubgroupInvocationID;
    const uint own = slot < held ? nearest.slot[row].id : 0u;
    // No sum of 64 comes near the end of the range.
    const uint up_to = optical + subgroupInclusiveAdd(own);
    optical += subgroupAdd(own);
    if (slot < held) {
      const float depth = pelage_depth_from_key(nearest.slot[row].key);
      entries[first + slot] = uvec2(floatBitsToUint(depth), up_to);
      moments -= moment(pelage_fragment(depth, own), scale_of_depth);
    }
  }
  const float last_depth = held > 0u ? pelage_depth_from_key(pelage_group_select_at(nearest, held - 1u).key) : 0.0;
  const bool is_rest = count > held;
  const uint rest = behind(optical);
  const float rest_depth = subgroupMax(farthest);
  const float mean = mean_depth(subgroupAdd(moments), rest, scale_of_depth);
  if (subgroupElect()) {
    put_texel(pixel, texel(first, held, is_rest ? rest : 0u, is_rest ? rest_depth : 0.0, last_depth, optical,
                           limits[pixel], mean));
  }
}
