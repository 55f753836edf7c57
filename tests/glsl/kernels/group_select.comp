// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
layout(local_size_x_id = 0) in;
layout(constant_id = 1) const uint lanes = 32u;
const uint rows = (64u + lanes - 1u) / lanes;
#include "pelage/glsl/core/fragment.glsl"
layout(std430, binding = 0) readonly buffer fragment_block {
  pelage_fragment pool[];
};
layout(std430, binding = 1) readonly buffer list_block {
  uvec4 lists[];  // begin, end, K, two passes or one
};
layout(std430, binding = 2) writeonly buffer behind_block {
  uint behind[];  // by fragment
};
layout(std430, binding = 3) writeonly buffer result_block {
  uint results[];  // a list: fragments held, then 64 slots of key, id and place, then what at() gives for the last slot
};
shared uint words[6u * gl_WorkGroupSize.x];
#define PELAGE_SUBGROUP_SIZE lanes
#define PELAGE_SUBGROUP_WORDS(i) words[6u * lanes * gl_SubgroupID + (i)]
#define PELAGE_GROUP_SELECT_ROWS rows
#include "pelage/glsl/order/group_select.glsl"

void put(uint first, pelage_placed_fragment f) {
  results[first] = f.key;
  results[first + 1u] = f.id;
  results[first + 2u] = f.place;
}

void main() {
  const uint list = gl_WorkGroupID.x * gl_NumSubgroups + gl_SubgroupID;
  if (list >= uint(lists.length())) return;
  const uint begin = lists[list].x;
  const uint end = lists[list].y;
  const uint k = lists[list].z;
  pelage_group_select nearest;
  pelage_group_select_clear(nearest, k);
  if (lists[list].w != 0u) {
    for (uint i = begin + gl_SubgroupInvocationID; i < end; i += lanes) {
      pelage_group_select_offer_depth(nearest, pool[i]);
    }
    pelage_group_select_limit(nearest);
  }
  for (uint from = begin; from < end; from += lanes) {
    const uint i = from + gl_SubgroupInvocationID;
    pelage_fragment offered = pelage_no_fragment();
    if (i < end) offered = pool[i];
    pelage_group_select_insert(nearest, offered, i);
  }
  pelage_group_select_finish(nearest);
  const uint first = 196u * list;
  for (uint row = 0u; row < rows; ++row) {
    const uint slot = row * lanes + gl_SubgroupInvocationID;
    if (slot < 64u) put(first + 1u + 3u * slot, nearest.slot[row]);
  }
  const uint held = pelage_group_select_held(nearest);
  const pelage_placed_fragment last = pelage_group_select_at(nearest, k - 1u);
  if (gl_SubgroupInvocationID == lanes - 1u) {
    results[first] = held;
    put(first + 193u, last);
  }
  for (uint i = begin + gl_SubgroupInvocationID; i < end; i += lanes) {
    behind[i] = uint(pelage_group_select_is_behind(nearest, pool[i]));
  }
}
