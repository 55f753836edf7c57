// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Gives each pixel its run of the pool, in any order: what is in a run matters, not where it lies. In: counts. Out:
// runs, and in counts the first free place of each. Pixels that the view has no room for get a shorter run. One
// invocation a pixel; bounded by one atomic add a subgroup on a single word.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "scene.glsl"

void main() {
  const ivec2 at = pixel_of(invocation());
  const bool inside = is_inside(at);
  const uint pixel = VIEW.first_pixel + index_of(at);
  const uint wanted = inside ? counts[pixel] : 0u;
  const uint before = subgroupExclusiveAdd(wanted);
  const uint sum = subgroupAdd(wanted);
  uint carries = subgroupBallotBitCount(subgroupBallot(before + wanted < wanted));
  uint base = 0u;
  if (subgroupElect()) {
    base = atomicAdd(reports[this_view()].taken, sum);
    carries += base + sum < sum ? 1u : 0u;
    if (carries > 0u) {
      atomicAdd(reports[this_view()].carries, carries);
    }
  }
  const uint first = min(VIEW.first_place + subgroupBroadcastFirst(base) + before, VIEW.end_place);
  const uint held = min(wanted, VIEW.end_place - first);
  if (inside) {
    runs[pixel] = uvec2(first, first + held);
    counts[pixel] = first;
  }
}
