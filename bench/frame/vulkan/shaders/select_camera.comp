// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The picture from the camera's runs: the K nearest fragments of each pixel in order, the rest as one layer behind
// them, over the background. In: runs, counts, records, shaded, sample_depths, picture. Out: picture. One subgroup a
// pixel; bounded by the scattered loads of the radiance at the two ends of each fragment's segment.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_shuffle_relative : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "nearest.glsl"
#include "camera_sink.glsl"

/// The K nearest of each subgroup's pixel, nearest first: radiance, opacity and coverage.
shared vec4 held_colour[gl_WorkGroupSize.x / lanes * uint(K)];
shared float held_coverage[gl_WorkGroupSize.x / lanes * uint(K)];

pelage_fragment offered_at(uint i) {
  return pelage_fragment(uintBitsToFloat(records[i].x), records[i].y);
}

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
  const uvec2 last = kth();
  const uint first_held = gl_SubgroupID * uint(K);
  for (uint from = begin; from < end; from += lanes) {
    const uint i = from + gl_SubgroupInvocationID;
    const uvec4 record = records[min(i, end - 1u)];
    const uvec2 key = key_of(pelage_fragment(uintBitsToFloat(record.x), record.y));
    const uint slot = slot_of(key);
    if (i < end) {
      const seen_fibre fibre = see(record.y, touch(uintBitsToFloat(record.x), uintBitsToFloat(record.z),
                                                   uintBitsToFloat(record.w)));
      if (key_before(last, key)) {
        sink_put_behind(fibre);
      } else {
        held_colour[first_held + slot] = vec4(fibre.radiance, fibre.opacity);
        held_coverage[first_held + slot] = fibre.coverage;
      }
    }
  }
  subgroupMemoryBarrierShared();
  subgroupBarrier();
  for (uint slot = first_held; slot < first_held + min(end - begin, uint(K)); ++slot) {
    sink_add(seen_fibre(held_colour[slot].rgb, held_colour[slot].a, held_coverage[slot]));
  }
  if (end - begin > uint(K)) {
    sink_behind = sum_over_lanes(sink_behind);
  }
  if (subgroupElect()) {
    sink_finish(at);
  }
}
