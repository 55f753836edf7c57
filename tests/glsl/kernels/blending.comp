// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#define FRAGMENTS 8u
#define STRIDE (3u * FRAGMENTS + 7u)
#define RESULTS 87u
#include "table.glsl"

#define PELAGE_ATOMIC_CELLS_WORDS(i) results[i]
#include "pelage/glsl/composite/depth_peeling.glsl"
#include "pelage/glsl/composite/order_weighted.glsl"
#include "pelage/glsl/composite/stochastic.glsl"
#include "pelage/glsl/composite/weighted_average.glsl"
#include "pelage/glsl/composite/weighted_blended.glsl"
#include "pelage/glsl/composite/weighted_sum.glsl"
#include "pelage/glsl/order/slice_pieces.glsl"

uint next = 0u;
void give(uint value) { put(next++, value); }
void give(float value) { put(next++, value); }
void give(vec3 value) {
  put(next, value);
  next += 3u;
}
void give(pelage_fragment value) {
  give(value.depth);
  give(value.id);
}

void main() {
  if (outside()) return;
  const vec3 colour = v3(3u * FRAGMENTS);
  const float share = f(3u * FRAGMENTS + 3u);
  const float order = f(3u * FRAGMENTS + 4u);
  const uint seed = u(3u * FRAGMENTS + 5u);
  pelage_tail tail = pelage_empty_tail();
  pelage_weighted_average average = pelage_weighted_average_empty();
  pelage_weighted_average others = pelage_weighted_average_empty();
  pelage_stochastic_depths depths = pelage_stochastic_depths_empty();
  for (uint i = 0u; i < FRAGMENTS; ++i) {
    const pelage_fragment offered = pelage_fragment(f(3u * i), u(3u * i + 1u));
    const float alpha = f(3u * i + 2u);
    tail = pelage_add_weighted(tail, alpha, pelage_depth_weight(alpha, share), colour);
    if (i % 2u == 0u) {
      pelage_weighted_average_add(average, alpha, colour);
    } else {
      pelage_weighted_average_add(others, alpha, colour);
    }
    pelage_stochastic_depths_add(depths, offered, alpha, pelage_stochastic_stream(seed, i % 2u));
  }
  pelage_weighted_average_merge(average, others);
  pelage_depth_peeling peeled = pelage_depth_peeling_begin();
  pelage_dual_depth_peeling dual = pelage_dual_depth_peeling_begin();
  for (uint pass = 0u; pass < 5u; ++pass) {
    for (uint i = 0u; i < FRAGMENTS; ++i) {
      const pelage_fragment offered = pelage_fragment(f(3u * i), u(3u * i + 1u));
      pelage_depth_peeling_offer(peeled, offered);
      pelage_dual_depth_peeling_offer(dual, offered);
    }
    give(pelage_depth_peeling_layer(peeled));
    give(pelage_dual_depth_peeling_front(dual));
    give(pelage_dual_depth_peeling_back(dual));
    pelage_depth_peeling_advance(peeled);
    pelage_dual_depth_peeling_advance(dual);
  }
  give(tail.optical);
  give(tail.weight);
  give(tail.red);
  give(tail.green);
  give(tail.blue);
  give(pelage_resolve(tail, colour.zyx));
  give(pelage_resolve_unscaled(tail, colour.zyx));
  give(average.count);
  give(average.sums.optical);
  give(average.sums.weight);
  give(average.sums.red);
  give(pelage_weighted_average_transmittance(average));
  give(pelage_weighted_average_resolve(average, colour.zyx));
  for (uint i = 0u; i < 16u; ++i) give(depths.nearest[i]);
  give(pelage_stochastic_depths_transmittance_before(depths, order));
  give(pelage_order_weight(share, order));
  give(pelage_optical_weight(share, order));
  give(pelage_depth_weight(share, order));
  give(pelage_distance_weight(share, 0.05 * order, 6.0));
  const float end = f(3u * FRAGMENTS + 6u);
  give(pelage_slice_sort_slice_of(order, end, 20u));
  give(pelage_slice_sort_piece_count(order, end, 20u));
  for (uint i = 0u; i < 5u; ++i) {
    const uint number = min(i, pelage_slice_sort_piece_count(order, end, 20u) - 1u);
    const pelage_slice_sort_piece piece = pelage_slice_sort_piece_at(order, end, 20u, number);
    give(piece.slice);
    give(piece.begin);
    give(piece.end);
  }
}
