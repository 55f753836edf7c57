// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Where the camera's fragments go once they are in order: over the picture's opaque background. See camera_film in
// bench/frame/shading/camera_film.hpp; radiance is interpolated between the strand's points, which shade.comp has lit.
#ifndef PELAGE_FRAME_CAMERA_SINK_GLSL
#define PELAGE_FRAME_CAMERA_SINK_GLSL
#include "pelage/glsl/composite/radiance.glsl"
#include "pelage/glsl/composite/tail.glsl"
#include "raster.glsl"

uint sink_at;
float sink_nearest_solid;
pelage_pixel_radiance sink_pixel;
pelage_tail sink_behind;

const uint samples_side = 3u;  ///< samples of the opaque objects along a pixel's side, anti-aliased
const uint samples = samples_side * samples_side;

/// What the camera sees of a fragment.
struct seen_fibre {
  vec3 radiance;
  float opacity;
  float coverage;
};

uint first_sample() {
  return (samples + 1u) * sink_at;
}

/// The share of the pixel's opaque samples that lie behind a depth.
float share_in_front(float depth) {
  if (!scene.antialias || depth < sink_nearest_solid) {
    return 1.0;
  }
  uint behind = 0u;
  for (uint i = 0u; i < samples; ++i) {
    behind += depth < sample_depths[first_sample() + i] ? 1u : 0u;
  }
  return float(behind) / float(samples);
}

vec4 shaded_at(uint i) {
  const uvec2 word = shaded[i];
  return vec4(unpackHalf2x16(word.x), unpackHalf2x16(word.y));
}

/// A fragment whose place on the segment is known.
seen_fibre see(uint i, segment_in_pixel where) {
  const vec4 mean = mix(shaded_at(i), shaded_at(i + 1u), where.along);
  return seen_fibre(mean.rgb, mean.a, where.coverage * share_in_front(where.depth));
}

/// And where it has to be found again.
seen_fibre see(pelage_fragment f) {
  const ivec2 at = ivec2(sink_at % uint(VIEW.size.x), sink_at / uint(VIEW.size.x));
  return see(f.id, look_at(place(f.id), at));
}

/// What see() sees from then on.
void sink_go_to(uint pixel) {
  sink_at = pixel;
  sink_nearest_solid = scene.antialias ? sample_depths[first_sample() + samples] : uintBitsToFloat(0x7f800000u);
}

void sink_begin(ivec2 at, bool whole) {
  sink_go_to(index_of(at));
  sink_pixel = pelage_empty_pixel();
  sink_behind = pelage_empty_tail();
}

void sink_put_behind(seen_fibre fibre) {
  sink_behind = pelage_add_fragment(sink_behind, fibre.opacity * fibre.coverage, fibre.radiance);
}

void sink_lose(pelage_fragment f) {
  sink_put_behind(see(f));
}

void sink_add(seen_fibre fibre) {
  sink_pixel = pelage_add_fibre(sink_pixel, fibre.radiance, vec3(1.0 - fibre.opacity), fibre.coverage);
}

void sink_keep(pelage_fragment f) {
  sink_add(see(f));
}

void sink_finish(ivec2 at) {
  const uint p = 3u * index_of(at);
  const vec3 background = vec3(picture[p], picture[p + 1u], picture[p + 2u]);
  sink_pixel = pelage_add_tail(sink_pixel, sink_behind);
  const vec3 colour = pelage_resolve(sink_pixel, background);
  picture[p] = colour.r;
  picture[p + 1u] = colour.g;
  picture[p + 2u] = colour.b;
}

#endif
