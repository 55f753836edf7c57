// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The picture from the camera's runs: the K nearest fragments of each pixel in order, the rest as one layer behind
// them, over the background. In: runs, counts, pool, points, shaded, sample_depths, picture. Out: picture. One subgroup
// a pixel; bounded by the scattered loads of what each fragment is made of.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_shuffle_relative : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "nearest.glsl"
#include "camera_sink.glsl"

pelage_tail sum_over_lanes(pelage_tail t) {
  for (uint stride = lanes / 2u; stride > 0u; stride /= 2u) {
    t = pelage_merge(
        t, pelage_tail(subgroupShuffleXor(t.optical, stride), subgroupShuffleXor(t.weight, stride),
                       subgroupShuffleXor(t.red, stride), subgroupShuffleXor(t.green, stride),
                       subgroupShuffleXor(t.blue, stride)));
  }
  return t;
}

void main() {
  const ivec2 at = pixel_of_subgroup();
  if (!is_inside(at)) {
    return;
  }
  const uint pixel = index_of(at);
  const uint begin = runs[pixel].x;
  const uint end = min(counts[pixel], runs[pixel].y);
  if (begin == end) {
    return;  // the background is there already
  }
  select_nearest(begin, end);
  sink_begin(at, false);
  if (end - begin > uint(K)) {
    const uvec2 last = kth();
    for (uint i = begin + gl_SubgroupInvocationID; i < end; i += lanes) {
      const pelage_fragment f = pool[i];
      if (key_before(last, key_of(f))) {
        sink_lose(f);
      }
    }
    sink_behind = sum_over_lanes(sink_behind);
  }
  const uint held = min(end - begin, uint(K));
  for (uint row = 0u; row < rows; ++row) {
    seen_fibre mine = seen_fibre(vec3(0.0), 0.0, 0.0);
    if (row * lanes + gl_SubgroupInvocationID < held) {
      mine = see(fragment_from(nearest[row]));
    }
    const uint last = min(held - min(held, row * lanes), lanes);
    for (uint lane = 0u; lane < last; ++lane) {
      sink_add(seen_fibre(subgroupShuffle(mine.radiance, lane), subgroupShuffle(mine.opacity, lane),
                          subgroupShuffle(mine.coverage, lane)));
    }
  }
  if (subgroupElect()) {
    sink_finish(at);
  }
}
