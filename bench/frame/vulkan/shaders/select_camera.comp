// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The picture from the camera's runs, or with BLOCKS from lists: the K nearest fragments of each pixel in order, the
// rest as one layer behind them, or with TRUNCATED nowhere, over the background. In: runs, counts or links, records,
// shaded, edges, picture. Out: picture. One subgroup a pixel; bounded by the scattered loads of the radiance at the two
// ends of each fragment's segment.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#ifdef BLOCKS
#include "block_walk.glsl"
#else
#include "selection.glsl"
#endif
#include "camera_sink.glsl"

pelage_fragment fragment_at(uint i) {
  return pelage_fragment(uintBitsToFloat(records[i].x), records[i].y);
}

#ifdef BLOCKS
void note(pelage_fragment f) {}
#else
// The pixel's run.
uint begin;
uint end;

/// Takes in a pixel's run. How many fragments it has.
uint select_from(uint pixel) {
  begin = runs[pixel].x;
  end = min(counts[pixel], runs[pixel].y);
  if (begin == end) {
    return 0u;
  }
  pelage_group_select_clear(nearest, uint(K));
  if (end - begin > lanes) {
    for (uint i = begin + gl_SubgroupInvocationID; i < end; i += lanes) {
      pelage_group_select_offer_depth(nearest, fragment_at(i));
    }
    pelage_group_select_limit(nearest);
  }
  insert_run(begin, end);
  return end - begin;
}
#endif

/// What a record tells of its fragment.
seen_fibre see_record(uvec4 record) {
  return see(record.y, segment_in_pixel(uintBitsToFloat(record.x), uintBitsToFloat(record.z), uintBitsToFloat(record.w)));
}

/// The K nearest over each other, in all lanes.
void add_nearest(uint held) {
  for (uint row = 0u; row * lanes < held; ++row) {
    const seen_fibre mine = see_record(records[row * lanes + gl_SubgroupInvocationID < held ? nearest.slot[row].place : 0u]);
    const uvec4 before = subgroupBallot(mine.is_before_edge);
    for (uint lane = 0u; lane < min(held - row * lanes, lanes); ++lane) {
      sink_add(seen_fibre(subgroupShuffle(mine.radiance, lane), subgroupShuffle(mine.opacity, lane),
                          subgroupShuffle(mine.coverage, lane), subgroupBallotBitExtract(before, lane)));
    }
  }
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

void put_if_behind(uvec4 record) {
  if (pelage_group_select_is_behind(nearest, pelage_fragment(uintBitsToFloat(record.x), record.y))) {
    sink_put_behind(see_record(record));
  }
}

/// Puts what is not kept behind.
void put_rest_behind(uint pixel) {
#ifdef BLOCKS
  pelage_unrolled_walk walk = walk_from(pixel);
  while (walk.size > 0u) {
    const uvec4 record = records[own_place(walk)];
    const bool is_mine = has_own(walk);
    pelage_unrolled_walk_go_to(walk, walk.then);
    if (is_mine) {
      put_if_behind(record);
    }
  }
#else
  for (uint i = begin + gl_SubgroupInvocationID; i < end; i += lanes) {
    put_if_behind(records[i]);
  }
#endif
}

void main() {
  const ivec2 at = pixel_of_subgroup();
  if (!is_inside(at)) {
    return;
  }
#ifdef BLOCKS
  const uint pixel = index_of(at);
#else
  const uint pixel = VIEW.first_pixel + index_of(at);
#endif
  const uint count = select_from(pixel);
  if (count == 0u) {
    return;  // the background is there already
  }
  const uint held = pelage_group_select_held(nearest);
  sink_begin(at, false);
  add_nearest(held);
#ifndef TRUNCATED
  if (count > held) {
    put_rest_behind(pixel);
    sink_before = sum_over_lanes(sink_before);
    if (subgroupBallot(sink_behind.optical != 0u || sink_behind.weight != 0u) != uvec4(0u)) {
      sink_behind = sum_over_lanes(sink_behind);
    }
  }
#endif
  if (subgroupElect()) {
    sink_finish(at);
  }
}
