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

/// The pixel that this subgroup works at, of all its view's.
ivec2 pixel_of_subgroup() {
  const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return pixel_of(group * gl_NumSubgroups + gl_SubgroupID);
}

#endif
