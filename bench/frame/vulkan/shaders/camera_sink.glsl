// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Where the camera's fragments go once they are in order: over the picture's opaque background. See camera_film in
// bench/frame/shading/camera_film.hpp; radiance is interpolated between the strand's points, which shade.comp has lit.
#ifndef PELAGE_FRAME_CAMERA_SINK_GLSL
#define PELAGE_FRAME_CAMERA_SINK_GLSL
#include "edge.glsl"
#include "raster.glsl"

uint sink_at;
float sink_edge;
pelage_divided_pixel sink_pixel;
pelage_tail sink_before;  ///< the edge, of what is lost
pelage_tail sink_behind;

/// What the camera sees of a fragment.
struct seen_fibre {
  vec3 radiance;
  float opacity;
  float coverage;
  bool is_before_edge;
};

vec4 shaded_at(uint i) {
  const uvec2 word = shaded[i];
  return vec4(unpackHalf2x16(word.x), unpackHalf2x16(word.y));
}

/// A fragment whose place on the segment is known.
seen_fibre see(uint i, segment_in_pixel where) {
  const vec4 mean = mix(shaded_at(i), shaded_at(i + 1u), where.along);
  return seen_fibre(mean.rgb, mean.a, where.coverage, where.depth < sink_edge);
}

/// And where it has to be found again.
seen_fibre see(pelage_fragment f) {
  const ivec2 at = ivec2(sink_at % uint(VIEW.size.x), sink_at / uint(VIEW.size.x));
  return see(f.id, look_at(place(f.id), at));
}

/// What see() sees from then on.
void sink_go_to(uint pixel) {
  sink_at = pixel;
  sink_edge = edges[first_of_edge(pixel)];
}

void sink_begin(ivec2 at, bool whole) {
  sink_go_to(index_of(at));
  sink_pixel = pelage_empty_divided_pixel();
  sink_before = pelage_empty_tail();
  sink_behind = pelage_empty_tail();
}

void sink_put_behind(seen_fibre fibre) {
  const pelage_tail one = pelage_add_fragment(pelage_empty_tail(), fibre.opacity * fibre.coverage, fibre.radiance);
  if (fibre.is_before_edge) {
    sink_before = pelage_merge(sink_before, one);
  } else {
    sink_behind = pelage_merge(sink_behind, one);
  }
}

void sink_lose(pelage_fragment f) {
#ifndef TRUNCATED
  sink_put_behind(see(f));
#endif
}

void sink_add(seen_fibre fibre) {
  sink_pixel = pelage_add_fibre(sink_pixel, fibre.is_before_edge, fibre.radiance, vec3(1.0 - fibre.opacity),
                                fibre.coverage);
}

void sink_keep(pelage_fragment f) {
  sink_add(see(f));
}

void sink_finish(ivec2 at) {
  const uint pixel = index_of(at);
  const pelage_divided_pixel whole = pelage_add_tails(sink_pixel, sink_before, sink_behind);
  const vec3 colour = pelage_resolve(whole, load_backdrop(pixel));
  picture[3u * pixel] = colour.r;
  picture[3u * pixel + 1u] = colour.g;
  picture[3u * pixel + 2u] = colour.b;
}

#endif
