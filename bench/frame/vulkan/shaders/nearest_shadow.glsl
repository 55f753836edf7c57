// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What a light's maps of the K nearest fragments let through, as bench/frame/shadows/k_buffer_shadow.hpp has it.
#ifndef PELAGE_FRAME_NEAREST_SHADOW_GLSL
#define PELAGE_FRAME_NEAREST_SHADOW_GLSL
#include "pelage/glsl/composite/optical_depth.glsl"
#include "texel.glsl"

float entry_depth(uint i) {
  return uintBitsToFloat(entries[i].x);
}

/// The share of the rest that lies before a depth.
float share_before(texel t, float depth) {
  if (depth >= t.farthest) {
    return 1.0;
  }
  const float middle = clamp(t.mean, t.last_depth, t.farthest);
  const float reach = min(middle - t.last_depth, t.farthest - middle);
  return reach > 0.0 ? pelage_saturate(0.5 + 0.5 * (depth - middle) / reach) : depth < middle ? 0.0 : 1.0;
}

/// The optical depth before a depth, in a texel whose `before` first entries lie before it.
uint optical_before(texel t, uint before, float depth) {
  if (before < t.held) {
    return before > 0u ? entries[t.first + before - 1u].y : 0u;
  }
  if (t.behind == 0u) {
    return t.last_optical;
  }
  const float share = share_before(t, depth);
  const float greatest = 4294967040.0;  // the last float below 2^32
  return pelage_add_saturating(t.last_optical, uint(share * min(float(t.behind), greatest)));
}

/// What a texel lets through.
float transmittance_behind(texel t, uint before, float depth, bool among_fibres) {
  if (!among_fibres && depth > t.limit) {
    return 0.0;
  }
  return pelage_transmittance_of(optical_before(t, before, depth));
}

float transmittance_at(uint pixel, float depth, bool among_fibres) {
  const texel t = texel_in(pixel);
  uint before = 0u;
  for (uint stride = t.held > 0u ? 1u << uint(findMSB(t.held)) : 0u; stride > 0u; stride /= 2u) {
    const uint next = before + stride;
    before = next <= t.held && entry_depth(t.first + next - 1u) < depth ? next : before;
  }
  return transmittance_behind(t, before, depth, among_fibres);
}

/// A square of four texels, by rows, and how many entries of each lie before a depth. All four are searched at once: a
/// search waits for each of its loads, and so four wait together. Behind a texel's last entry there is nothing to
/// search.
void search_in(uint pixel, uint below, vec4 depth, out texel square[4], out uvec4 before) {
  square = texel[4](texel_in(pixel), texel_in(pixel + 1u), texel_in(below), texel_in(below + 1u));
  uint most = 0u;
  for (int t = 0; t < 4; ++t) {
    const bool is_search = square[t].held > 0u && !(square[t].last_depth < depth[t]);
    before[t] = is_search ? 0u : square[t].held;
    most = max(most, is_search ? square[t].held : 0u);
  }
  for (uint stride = most > 0u ? 1u << uint(findMSB(most)) : 0u; stride > 0u; stride /= 2u) {
    float probe[4];
    for (int t = 0; t < 4; ++t) {
      const uint next = before[t] + stride;
      probe[t] = next <= square[t].held ? entry_depth(square[t].first + next - 1u) : depth[t];
    }
    for (int t = 0; t < 4; ++t) {
      before[t] += probe[t] < depth[t] ? stride : 0u;
    }
  }
}

/// What a square of four texels lets through, by rows, each up to its depth.
vec4 transmittance_in(uint pixel, uint below, vec4 depth, bool among_fibres) {
  texel square[4];
  uvec4 before;
  search_in(pixel, below, depth, square, before);
  vec4 passed;
  for (int t = 0; t < 4; ++t) {
    passed[t] = transmittance_behind(square[t], before[t], depth[t], among_fibres);
  }
  return passed;
}

/// The optical depth of a square's fibres, each texel's up to its depth, and of all of them.
void optical_in(uint pixel, uint below, vec4 depth, out vec4 optical, out vec4 whole) {
  texel square[4];
  uvec4 before;
  search_in(pixel, below, depth, square, before);
  for (int t = 0; t < 4; ++t) {
    optical[t] = float(optical_before(square[t], before[t], depth[t]));
    whole[t] = float(pelage_add_saturating(square[t].last_optical, square[t].behind));
  }
}

#endif
