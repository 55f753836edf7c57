// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A light's map from its runs: the K nearest of each texel with the optical depth up to and including each, then the
// sum and the farthest depth of the rest. In: runs, counts, pool. Out: entries, texels. One subgroup a texel; bounded
// by shuffles, about K (1 + ln n / K) insertions a texel of n fragments.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_shuffle_relative : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "nearest.glsl"
#include "pelage/glsl/composite/optical_depth.glsl"

pelage_fragment offered_at(uint i) {
  return pool[i];
}

void main() {
  const ivec2 at = pixel_of_subgroup();
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = index_of(at);
  const uint begin = runs[pixel].x;
  const uint end = min(counts[pixel], runs[pixel].y);
  select_nearest(begin, end);

  const uint first = (VIEW.first_pixel + pixel) * uint(K);
  uint before = 0u;
  for (uint row = 0u; row < rows; ++row) {
    const uint slot = row * lanes + gl_SubgroupInvocationID;
    const bool held = slot < uint(K) && slot < end - begin;
    const uint optical = held ? nearest[row].y : 0u;
    // No sum of 64 comes near the end of the range.
    const uint up_to = before + subgroupInclusiveAdd(optical);
    before += subgroupAdd(optical);
    if (held) {
      entries[first + slot] = uvec2(floatBitsToUint(fragment_from(nearest[row]).depth), up_to);
    }
  }

  uint behind = 0u;
  float farthest = 0.0;
  if (end - begin > uint(K)) {
    // Fragments alike may lie on both sides of slot K: as many as the slots hold are not of the rest.
    const uvec2 last = kth();
    uint alike = 0u;
    for (uint row = 0u; row < rows; ++row) {
      const bool held = row * lanes + gl_SubgroupInvocationID < uint(K);
      alike += subgroupBallotBitCount(subgroupBallot(held && nearest[row] == last));
    }
    uint passed = 0u;
    for (uint from = begin; from < end; from += lanes) {
      const uint i = from + gl_SubgroupInvocationID;
      const pelage_fragment f = pool[min(i, end - 1u)];
      const bool same = i < end && key_of(f) == last;
      const uvec4 ballot = subgroupBallot(same);
      const bool left_over = same && passed + subgroupBallotExclusiveBitCount(ballot) >= alike;
      passed += subgroupBallotBitCount(ballot);
      if (left_over || (i < end && key_before(last, key_of(f)))) {
        behind = pelage_add_saturating(behind, f.id);
        farthest = max(farthest, f.depth);
      }
    }
    for (uint stride = lanes / 2u; stride > 0u; stride /= 2u) {
      behind = pelage_add_saturating(behind, subgroupShuffleXor(behind, stride));
    }
    farthest = subgroupMax(farthest);
  }
  if (subgroupElect()) {
    texels[VIEW.first_pixel + pixel] = uvec4(first, min(end - begin, uint(K)), behind, floatBitsToUint(farthest));
  }
}
