// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The opacity map of a pixel of a view (layer_sums of visibility/opacity_map.hpp) and the depth range that it may lie in,
// in cells that many invocations change at once, all 0 at first. The C++ side is ../layer_maps.hpp.
#ifndef PELAGE_FRAME_LAYER_MAP_GLSL
#define PELAGE_FRAME_LAYER_MAP_GLSL
#include "scene.glsl"

layout(std430, binding = 26) LIVE buffer layer_buffer { uint layer_cells[]; };

uint first_cell;  ///< of what the library's functions are about
#define PELAGE_ATOMIC_CELLS_WORDS(i) layer_cells[first_cell + (i)]
#include "pelage/glsl/visibility/depth_range.glsl"
#include "pelage/glsl/visibility/opacity_map.glsl"

// What view_block.layers holds beside the number of layers: where they begin, and how wide they are.
const uint from_nearest = 0x80000000u;   ///< at the pixel's nearest depth, else at layer_first
const uint to_farthest = 0x40000000u;    ///< and they reach to its farthest, else the first is layer_width wide
const uint growing_widths = 0x20000000u;  ///< the others two, three... times as wide
const uint layer_mask = 0xffffu;

// `texel`: among those of all views.

uint layers_of(uint v) {
  return scene.views[v].layers & layer_mask;
}

/// Cells a texel: the layers, a bit a sum that passed its end, nine of sums.glsl among them, and the range.
uint layer_words(uint layers) {
  return layers == 0u ? 0u : layers + (layers + 40u) / 32u + 2u;
}

/// All lights have as many layers.
uint first_layer(uint v, uint texel) {
  const uint first_pixel = scene.views[v].first_pixel;
  return layer_words(layers_of(0u)) * first_pixel + layer_words(layers_of(v)) * (texel - first_pixel);
}

void go_to_range(uint v, uint texel) {
  first_cell = first_layer(v, texel) + layer_words(layers_of(v)) - 2u;
}

pelage_depth_range load_range_of(uint v, uint texel) {
  if ((scene.views[v].layers & from_nearest) == 0u) {
    return pelage_depth_range_empty();
  }
  go_to_range(v, texel);
  return pelage_atomic_depth_range_load(0u);
}

/// Where a depth lies among a texel's layers.
float layer_position(uint v, pelage_depth_range range, float depth) {
  const uint layers = layers_of(v);
  const uint how = scene.views[v].layers;
  if ((how & to_farthest) != 0u) {
    return pelage_slice_position(pelage_depth_range_relative(range, depth), layers);
  }
  const float first = (how & from_nearest) != 0u ? pelage_depth_range_nearest_depth(range) : scene.views[v].layer_first;
  const float width = scene.views[v].layer_width;
  return (how & growing_widths) != 0u ? pelage_growing_layer_position(depth - first, width, layers)
                                      : pelage_equal_layer_position(depth - first, width, layers);
}

/// What lies before a depth, of a map that is accumulated; `own` is not counted.
float amount_before(uint v, uint texel, float depth, uint own) {
  const float position = layer_position(v, load_range_of(v, texel), depth);
  first_cell = first_layer(v, texel);
  return pelage_layer_sums_accumulated_before(0u, layers_of(v), position, own);
}

// The same of the view that the shader works for, by the names of occupancy.glsl.

void extend_range(uint texel, float depth) {
  go_to_range(this_view(), texel);
  pelage_atomic_depth_range_extend(0u, depth);
}

pelage_depth_range load_range(uint texel) {
  return load_range_of(this_view(), texel);
}

float map_position(pelage_depth_range range, float depth) {
  return layer_position(this_view(), range, depth);
}

void occupy(uint texel, float position, uint amount) {
  first_cell = first_layer(this_view(), texel);
  pelage_layer_sums_add(0u, layers_of(this_view()), position, amount);
}

/// What lies before a fragment, itself left out, or with UNCORRECTED not.
float amount_before_fragment(uint texel, float depth, uint own) {
#ifdef UNCORRECTED
  return amount_before(this_view(), texel, depth, 0u);
#else
  return amount_before(this_view(), texel, depth, own);
#endif
}

void accumulate(uint texel) {
  first_cell = first_layer(this_view(), texel);
  pelage_layer_sums_accumulate(0u, layers_of(this_view()));
}

uint cell_of_end(uint texel, uint i) {
  const uint layers = layers_of(this_view());
  return first_layer(this_view(), texel) + layers + (layers + i) / 32u;
}

uint bit_of_end(uint i) {
  return 1u << ((layers_of(this_view()) + i) % 32u);
}

/// Notes that one of nine sums passed its end, of sums.glsl.
void mark_end(uint texel, uint i) {
  atomicOr(layer_cells[cell_of_end(texel, i)], bit_of_end(i));
}

uint passed_ends(uint texel) {
  uint passed = 0u;
  for (uint i = 0u; i < 9u; ++i) {
    passed |= (layer_cells[cell_of_end(texel, i)] & bit_of_end(i)) != 0u ? 1u << i : 0u;
  }
  return passed;
}

/// Of an accumulated map, or of a single layer.
uint total_of(uint texel) {
  const uint layers = layers_of(this_view());
  first_cell = first_layer(this_view(), texel);
  return pelage_load_marked(layers - 1u, layers + (layers - 1u) / 32u, 1u << ((layers - 1u) % 32u));
}

#endif
