// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Selection of the K nearest of a pixel's list of blocks, for a subgroup that works at the pixel.
#ifndef PELAGE_FRAME_BLOCK_WALK_GLSL
#define PELAGE_FRAME_BLOCK_WALK_GLSL
#include "selection.glsl"
#include "lists.glsl"
#include "pelage/glsl/order/unrolled_walk.glsl"

/// At a list's first nodes.
pelage_unrolled_walk walk_from(uint list) {
  pelage_unrolled_walk walk;
  pelage_unrolled_walk_go_to(walk, pelage_unrolled_list_first(list));
  return walk;
}

/// Where this lane's fragment lies, or if it has none another one's.
uint own_place(pelage_unrolled_walk walk) {
  return walk.begin + min(gl_SubgroupInvocationID, walk.size - 1u);
}

bool has_own(pelage_unrolled_walk walk) {
  return gl_SubgroupInvocationID < walk.size;
}

// The including shader's part in select_from().
void note(pelage_fragment f);

/// Takes in a list, and notes what this lane reads of it. How many fragments it has.
uint select_from(uint list) {
  pelage_group_select_clear(nearest, uint(K));
  uint count = 0u;
  pelage_unrolled_walk walk = walk_from(list);
  while (walk.size > 0u) {
    const uint place = own_place(walk);
    const bool is_mine = has_own(walk);
    const pelage_fragment f = fragment_at(place);
    count += walk.size;
    pelage_unrolled_walk_go_to(walk, walk.then);  // on its way while these are put in order
    if (is_mine) {
      note(f);
    }
    pelage_group_select_insert(nearest, pelage_fragment(f.depth, is_mine ? f.id : pelage_no_fragment().id), place);
  }
  pelage_group_select_finish(nearest);
  return count;
}

#endif
