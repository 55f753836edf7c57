// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Blocks of up to `each` fragments; with READ a subgroup reads each list, and says where its nodes lie.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "lists.glsl"
layout(constant_id = 1) const uint lanes = 32u;
layout(std430, binding = 4) writeonly buffer place_block {
  uint places[];  // of each list, from `each_list` times its number on
};

#define PELAGE_SUBGROUP_SIZE lanes
#define PELAGE_SUBGROUP_WORDS(i) places[i]
#include "pelage/glsl/order/unrolled_walk.glsl"

const uint each = 5u;

#ifdef READ
void main() {
  const uint list = gl_WorkGroupID.x * gl_NumSubgroups + gl_SubgroupID;
  if (list >= lists) return;
  const uint each_list = uint(places.length()) / lists;
  uint read = each_list * list;
  pelage_unrolled_walk walk;
  pelage_unrolled_walk_go_to(walk, pelage_unrolled_list_first(list));
  while (walk.size > 0u) {
    if (gl_SubgroupInvocationID < walk.size && read + gl_SubgroupInvocationID < each_list * (list + 1u)) {
      places[read + gl_SubgroupInvocationID] = walk.begin + gl_SubgroupInvocationID;
    }
    read += walk.size;
    pelage_unrolled_walk_go_to(walk, walk.then);
  }
}
#else
void main() {
  const uint list = gl_GlobalInvocationID.x % lists;
  const uint from = gl_GlobalInvocationID.x / lists * each;  // of those that go to this list
  const uint all = (uint(offered.length()) + lists - 1u - list) / lists;
  if (from >= all) return;
  const uint wanted = min(each, all - from);
  const pelage_unrolled_list_node_block mine = pelage_unrolled_list_take(wanted);
  for (uint i = 0u; i < wanted; ++i) {
    if (i < mine.size) {
      pelage_atomic_list_storage_write_node(mine.first + i, offered[list + lists * (from + i)]);
    } else {
      pelage_atomic_list_storage_add_refused(pelage_memory_order_relaxed);
    }
  }
  pelage_unrolled_list_push(list, mine);
}
#endif
