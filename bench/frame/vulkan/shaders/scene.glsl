// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// What every pass of the frame shares: the scene's constants, the buffers, and how invocations are counted. The
// constants' C++ side is ../scene_block.hpp, the buffers' the enumeration `binding` in ../buffers.hpp.
#ifndef PELAGE_FRAME_SCENE_GLSL
#define PELAGE_FRAME_SCENE_GLSL
#include "pelage/glsl/core/fragment.glsl"

layout(local_size_x_id = 0) in;

layout(push_constant) uniform push_block {
  uint view;           ///< which of scene.views, of a dispatch for several the first
  uint capacity;       ///< fragments that the memory of a view with lists holds
  uint lists;          ///< a pixel's lists, of the methods that have them
  uint k;              ///< fragments kept a pixel, for the methods that are not compiled for one
  uint first_segment;  ///< of the slice that is drawn
  uint end_segment;
  float wind_phase[3];  ///< as model/sway.hpp has them
  float wind_bend;
  float wind_scale;
} push;

struct view_block {
  vec3 right;  ///< rows of the rotation into view space
  float scale;
  vec3 up;
  float near_plane;
  vec3 back;
  bool perspective;
  vec3 eye;
  uint first_pixel;  ///< of this view, in the arrays that hold a value for each pixel of each view
  ivec2 size;
  float cone_base;
  float cone_slope;
  float reach;  ///< pixels beside a fibre's axis that it may touch: this times its radius and the disc's
  uint first_place;  ///< of the pool, for this view's runs
  uint first_stamp;
  uint stamp_count;
  uint first_block;  ///< in block_limits
  uint first_opacity;
  uint layers;        ///< of the view's opacity maps, 0 without, and how they lie (layer_map.glsl)
  float layer_first;  ///< view depth where they begin, and the first one's width, where texels don't say
  float layer_width;
  float line_nearest;  ///< of lines' depth bins; with line_bin 0 all lines have their width at this depth
  float line_bin;
  float line_last;
  uint end_place;  ///< of this view's runs
};

struct light_block {
  vec3 position;
  uint kind;  ///< 0 directional, 1 point, 2 spot
  vec3 direction;
  float cos_outer;
  vec3 colour;
  float cos_inner;
};

struct ellipsoid_block {
  vec3 centre;
  float unused0;
  vec3 radii;
  float unused1;
};

struct copy_block {
  vec2 at;  ///< x and z
  float cosine;
  float sine;
};

struct sphere_block {
  vec3 centre;
  float radius;
};

struct view_report {
  uint fragments;  ///< in runs
  uint longest;    ///< fragments of the pixel that has most
  uint refused;    ///< that found no place
  uint taken;      ///< nodes or places of the pool in use
  uint stamps;     ///< beside the first of each segment
  uint carries;    ///< multiples of 2^32 beyond taken, after a tally beyond fragments
};

layout(std140, binding = 0) uniform scene_block {
  view_block views[9];  ///< the lights' and, at light_count, the camera's
  light_block lights[8];
  ellipsoid_block parts[8];
  vec3 sky;
  uint light_count;
  vec3 centre;  ///< of the sphere round the fibres
  float radius;
  vec3 skin;
  uint part_count;
  vec3 ground;
  float floor_height;
  float floor_clear;
  bool has_floor;
  bool shadows;
  bool translucent;
  bool antialias;
  uint segment_count;
  float eta;  ///< of fibres that stop what Fresnel's equations say; else 0
  float diffuse;  ///< Kajiya-Kay's K_d
  vec3 ambient;
  float specular;  ///< K_s
  float exponent;  ///< p
  uint copy_count;  ///< of all parts; 0: they stand as they are
  copy_block copies[128];
  sphere_block bodies[128];   ///< one a copy
  sphere_block clusters[16];  ///< of cluster_size copies each
} scene;

const uint cluster_size = 8u;

// What a segment's word holds beside its first point.
const uint begins_strand = 0x80000000u;
const uint ends_strand = 0x40000000u;
const uint point_mask = 0x3fffffffu;

/// What others write while a shader reads it is coherent; all else may be cached.
#ifdef READS_WHILE_OTHERS_WRITE
#define LIVE coherent
#else
#define LIVE
#endif

layout(std430, binding = 1) readonly buffer point_buffer { vec4 points[]; };  ///< world position, radius
layout(std430, binding = 2) readonly buffer tangent_buffer { float tangents[]; };
layout(std430, binding = 3) readonly buffer colour_buffer { float colours[]; };
layout(std430, binding = 4) readonly buffer opacity_buffer { float opacities[]; };  ///< a point, of each view if they differ
layout(std430, binding = 5) readonly buffer segment_buffer { uint segments[]; };  ///< first point and the two bits
layout(std430, binding = 6) buffer record_buffer { uvec4 records[]; };  ///< a fragment, its coverage, where it lies
layout(std430, binding = 7) buffer limit_buffer { float limits[]; };  ///< a pixel of a view: hidden from this depth on
layout(std430, binding = 8) buffer edge_buffer { float edges[]; };  ///< of the camera's pixels: edge, far share and light
layout(std430, binding = 9) buffer count_buffer { uint counts[]; };  ///< a view's pixel: its room, then the next place
layout(std430, binding = 10) buffer run_buffer { uvec2 runs[]; };  ///< a view's pixel: its part of the pool, [x, y)
layout(std430, binding = 11) LIVE buffer pool_buffer { pelage_fragment pool[]; };
layout(std430, binding = 13) buffer entry_buffer { uvec2 entries[]; };  ///< depth, optical depth up to and including
layout(std430, binding = 14) buffer shaded_buffer { uvec2 shaded[]; };  ///< a point: radiance, opacity; four halves
layout(std430, binding = 15) buffer seen_buffer { uint seen[]; };  ///< a point: the camera sees the segment from it on
layout(std430, binding = 16) buffer picture_buffer { float picture[]; };  ///< linear RGB
layout(std430, binding = 17) buffer report_buffer { view_report reports[]; };  ///< one a view
layout(std430, binding = 18) LIVE buffer link_buffer { uint links[]; };
layout(std430, binding = 23) buffer block_limit_buffer { uint block_limits[]; };  ///< the farthest limit of a block

/// The view that this workgroup works for: of a dispatch for several, one a layer of workgroups.
uint this_view() {
  return push.view + gl_WorkGroupID.z;
}

#define VIEW scene.views[this_view()]

bool is_camera() {
  return this_view() == scene.light_count;
}

/// The number of this invocation in a dispatch of any shape.
uint invocation() {
  const uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return group * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
}

const int block_side = 8;

/// The number of a block of 8 × 8 pixels.
uint block_index(ivec2 block) {
  return uint(block.y * ((VIEW.size.x + block_side - 1) / block_side) + block.x);
}

/// The pixel of an invocation, block by block: neighbours have lists of like length. May lie outside.
ivec2 pixel_of(uint i) {
  const uint across = uint(VIEW.size.x + block_side - 1) / uint(block_side);
  const uint block = i / 64u;
  return ivec2(8u * (block % across) + i % 8u, 8u * (block / across) + i / 8u % 8u);
}

bool is_inside(ivec2 at) {
  return at.x < VIEW.size.x && at.y < VIEW.size.y;
}

uint index_of(ivec2 at) {
  return uint(at.y) * uint(VIEW.size.x) + uint(at.x);
}

vec3 triple_of_tangents(uint i) {
  return vec3(tangents[3u * i], tangents[3u * i + 1u], tangents[3u * i + 2u]);
}

vec3 triple_of_colours(uint i) {
  return vec3(colours[3u * i], colours[3u * i + 1u], colours[3u * i + 2u]);
}

#endif
