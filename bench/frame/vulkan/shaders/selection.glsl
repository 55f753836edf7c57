// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The library's selection of the K nearest, for a subgroup that works at a pixel.
#ifndef PELAGE_FRAME_SELECTION_GLSL
#define PELAGE_FRAME_SELECTION_GLSL
#include "scene.glsl"
#include "subgroup.glsl"

const uint rows = (uint(K) + lanes - 1u) / lanes;

shared uint words[6u * gl_WorkGroupSize.x];

#define PELAGE_SUBGROUP_SIZE lanes
#define PELAGE_SUBGROUP_WORDS(i) words[6u * lanes * gl_SubgroupID + (i)]
#define PELAGE_GROUP_SELECT_ROWS rows
#define PELAGE_UNROLL [[unroll]]
#include "pelage/glsl/order/group_select.glsl"

pelage_group_select nearest;

// The including shader says where the fragments of runs lie.
pelage_fragment fragment_at(uint i);

/// The second pass over the run [begin, end), which is not empty.
void insert_run(uint begin, uint end) {
  for (uint from = begin; from < end; from += lanes) {
    const uint i = from + gl_SubgroupInvocationID;
    const pelage_fragment f = fragment_at(min(i, end - 1u));
    pelage_group_select_insert(nearest, pelage_fragment(f.depth, i < end ? f.id : pelage_no_fragment().id), i);
  }
  pelage_group_select_finish(nearest);
}

/// The pixel that this subgroup works at, of all its view's.
ivec2 pixel_of_subgroup() {
  const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return pixel_of(group * gl_NumSubgroups + gl_SubgroupID);
}

#endif
