// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Where a light's fragments go once they are in order: the texel's entries, each with the optical depth up to and
// including it, then the sum, the mean and the farthest depth of those that were not kept. See bench/frame/shadows/shadow_map.hpp.
#ifndef PELAGE_FRAME_LIGHT_SINK_GLSL
#define PELAGE_FRAME_LIGHT_SINK_GLSL
#include "pelage/glsl/composite/optical_depth.glsl"
#include "texel.glsl"

uint sink_first;
uint sink_held;
uint sink_optical;
float sink_depth;
uint sink_behind;
float sink_farthest;
uint sink_moments;
float sink_per_far;

/// `whole`: all fragments are kept, in entries as many as the pixel's run has.
void sink_begin(ivec2 at, bool whole) {
  const uint pixel = VIEW.first_pixel + index_of(at);
  sink_first = whole ? runs[pixel].x : pixel * push.k;
  sink_held = 0u;
  sink_optical = 0u;
  sink_depth = 0.0;
  sink_behind = 0u;
  sink_farthest = 0.0;
  sink_moments = 0u;
  sink_per_far = per_far();
}

void sink_lose(pelage_fragment f) {
  sink_behind = pelage_add_saturating(sink_behind, f.id);
  sink_moments += moment(f, sink_per_far);
  sink_farthest = max(sink_farthest, f.depth);
}

void sink_keep(pelage_fragment f) {
  sink_optical = pelage_add_saturating(sink_optical, f.id);
  sink_depth = f.depth;
  entries[sink_first + sink_held++] = uvec2(floatBitsToUint(f.depth), sink_optical);
}

void sink_finish(ivec2 at) {
  const uint pixel = VIEW.first_pixel + index_of(at);
  put_texel(pixel, texel(sink_first, sink_held, sink_behind, sink_farthest, sink_depth, sink_optical, limits[pixel],
                         mean_depth(sink_moments, sink_behind, sink_per_far)));
}

#endif
