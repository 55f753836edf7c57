// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
layout(local_size_x_id = 0) in;
layout(std430, binding = 0) readonly buffer inputs {
  uint given[];
};
layout(std430, binding = 1) coherent buffer cell_block {
  uint total;
  uint mismatches;
  uint words[];
};
layout(std430, binding = 2) coherent buffer wide_block {
  uint64_t wides[];
};
shared uint lane_words[gl_WorkGroupSize.x];
#define PELAGE_SUBGROUP_WORDS(i) lane_words[gl_SubgroupID * gl_SubgroupSize + (i)]
#define FEATURES_CELLS_TOTAL total
#define FEATURES_CELLS_WORDS(i) words[i]
#define FEATURES_CELLS_WORDS_SIZE words.length()
#define FEATURES_CELLS_WIDES(i) wides[i]
#include "../../codegen/storage.glsl"

/// What features_use_lanes() gives where each lane passes its own number.
uint expected_of_lanes() {
  const uint sum = gl_SubgroupSize * (gl_SubgroupSize - 1u) / 2u;
  const uint other = gl_SubgroupSize - 1u - gl_SubgroupInvocationID;
  return sum + (max(gl_SubgroupSize, 4u) - 4u) + (max(other, 6u) - 6u) ^ sum;
}

void main() {
  if (features_use_lanes(gl_SubgroupInvocationID) != expected_of_lanes()) atomicAdd(mismatches, 1u);
  const uint i = gl_GlobalInvocationID.x;
  if (i >= uint(given.length())) return;
  features_use(i, given[i]);
  features_tally_add(given[i]);
  if (features_tally_is_first(11u)) atomicAdd(mismatches, 1u);  // cell 11 % 6: claimed by now
  features_histogram bins;
  for (uint bin = 0u; bin < features_histogram_bins; ++bin) {
    bins.held[bin] = features_place_in(given[i] + bin);
  }
  features_histogram_store(bins, 8u + i * features_histogram_bins);
  const features_histogram again = features_load_histogram(8u + i * features_histogram_bins);
  if (again != bins) atomicAdd(mismatches, 1u);
}
