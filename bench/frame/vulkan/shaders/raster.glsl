// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A segment's fragments in a view, exact coverage included, as bench/frame/raster.hpp has it. A shader that draws
// segments defines before the include what becomes of a fragment:
//   void visit(uint segment, ivec2 at, touch where)
#ifndef PELAGE_FRAME_RASTER_GLSL
#define PELAGE_FRAME_RASTER_GLSL
#include "pelage/glsl/composite/optical_depth.glsl"
#include "pelage/glsl/coverage/closest_points.glsl"
#include "pelage/glsl/coverage/disc_strip.glsl"
#include "pelage/glsl/coverage/segment_quad.glsl"
#include "projection.glsl"

// What a segment's word holds beside its first point.
const uint begins_strand = 0x80000000u;
const uint ends_strand = 0x40000000u;
const uint point_mask = 0x3fffffffu;

/// Beyond the fibre's own radius, a disc reaches half a pixel; the rest is for rounding.
const float margin = 0.75;

/// What a segment leaves in a pixel.
struct touch {
  float depth;
  float coverage;
  float along;
};

/// A segment in view space.
struct placed_segment {
  vec3 start;
  vec3 end;
  float start_radius;
  float end_radius;
};

uint first_point(uint segment) {
  return segments[segment] & point_mask;
}

precise placed_segment place(uint segment) {
  const uint i = first_point(segment);
  const vec4 a = points[i];
  const vec4 b = points[i + 1u];
  return placed_segment(to_view(push.view, a.xyz), to_view(push.view, b.xyz), a.w, b.w);
}

/// Where a pixel's ray passes a segment that touches the pixel.
precise touch touch_of(placed_segment s, ivec2 at) {
  const view_ray ray = ray_through(push.view, vec2(at) + 0.5);
  const pelage_closest_pair pair = pelage_closest_points(ray.origin, ray.direction, s.start, s.end);
  const float disc = pelage_radius_at(cone_of(push.view), pair.along_ray);
  const float fibre = s.start_radius + pair.along_segment * (s.end_radius - s.start_radius);
  const bool smooth_edges = scene.antialias || !is_camera();
  const float hit = pair.distance <= max(fibre, disc) ? 1.0 : 0.0;
  const float share = smooth_edges ? pelage_disc_strip_share(pair.distance, fibre, disc) : hit;
  const float axis_depth = -(s.start.z + pair.along_segment * (s.end.z - s.start.z));
  const bool in_front = min(pair.along_ray, axis_depth) >= VIEW.near_plane;
  return touch(pair.along_ray, in_front ? share : 0.0, pair.along_segment);
}

/// What is kept of a fragment in the view: the camera's is found again by its segment's number; a light needs its
/// optical depth alone, and fragments that have depth and optical depth in common are alike.
precise pelage_fragment fragment_of(uint segment, touch where) {
  if (is_camera()) {
    return pelage_fragment(where.depth, segment);
  }
  const uint i = first_point(segment);
  const float opacity =
      scene.translucent ? opacities[i] + where.along * (opacities[i + 1u] - opacities[i]) : 1.0;
  return pelage_fragment(where.depth, pelage_optical_depth(opacity * where.coverage));
}

#ifdef PELAGE_FRAME_DRAWS
void visit(uint segment, ivec2 at, touch where);

/// The first pixel of [low, high] whose centre does not lie before x; quads may reach beyond any int.
precise int first_centre_from(float x, int low, int high) {
  return int(ceil(clamp(x - 0.5, float(low), float(high))));
}

/// How far a pixel's centre lies past a joint along the strand, in units of no use but the sign.
precise float past(vec2 centre, vec2 joint, vec2 strand) {
  return dot(centre - joint, strand);
}

/// Draws one segment. True if it left a fragment.
bool draw(uint segment) {
  const placed_segment s = place(segment);
  const uint word = segments[segment];
  const uint i = word & point_mask;
  const vec2 start = to_pixel(push.view, s.start);
  const vec2 end = to_pixel(push.view, s.end);
  // The line through a joint at right angles to the strand divides the pixels between the segments that meet there.
  const vec2 before =
      (word & begins_strand) != 0u ? start : to_pixel(push.view, to_view(push.view, points[i - 1u].xyz));
  const vec2 after = (word & ends_strand) != 0u ? end : to_pixel(push.view, to_view(push.view, points[i + 2u].xyz));
  const vec2 start_joint = end - before;
  const vec2 end_joint = after - start;
  const bool seen_end_on = start_joint == vec2(0.0) && end_joint == vec2(0.0);

  const float widest = max(s.start_radius, s.end_radius);
  const pelage_segment_quad quad =
      pelage_expand_segment(s.start, s.end, widest, cone_of(push.view), VIEW.near_plane, margin);
  if (!quad.visible) {
    return false;
  }
  vec2 corner[4];
  bool bounded = true;
  for (int k = 0; k < 4; ++k) {
    bounded = bounded && (!VIEW.perspective || -quad.corner[k].z >= VIEW.near_plane);
    corner[k] = to_pixel(push.view, quad.corner[k]);
  }
  const float top = min(min(corner[0].y, corner[1].y), min(corner[2].y, corner[3].y));
  const float bottom = max(max(corner[0].y, corner[1].y), max(corner[2].y, corner[3].y));
  const int y1 = bounded ? first_centre_from(bottom, 0, VIEW.size.y) : VIEW.size.y;
  // Rows and pixels of a row are one loop: lanes with another number of rows stay together.
  int y = (bounded ? first_centre_from(top, 0, VIEW.size.y) : 0) - 1;
  int x = 0;
  int x1 = 0;
  bool any = false;
  for (;;) {
    while (x >= x1 && ++y < y1) {
      const float centre = float(y) + 0.5;
      float left = bounded ? 1e30 : -1e30;
      float right = -left;
      for (int k = 0; k < 4 && bounded; ++k) {
        const vec2 a = corner[k];
        const vec2 b = corner[(k + 1) & 3];
        if ((a.y <= centre) != (b.y <= centre)) {
          const float crossing = a.x + (centre - a.y) / (b.y - a.y) * (b.x - a.x);
          left = min(left, crossing);
          right = max(right, crossing);
        }
      }
      x = first_centre_from(left, 0, VIEW.size.x);
      x1 = first_centre_from(right, 0, VIEW.size.x);
    }
    if (y >= y1) {
      return any;
    }
    const ivec2 at = ivec2(x++, y);
    const vec2 centre = vec2(at) + 0.5;
    const bool inside = past(centre, start, start_joint) >= 0.0 && past(centre, end, end_joint) < 0.0;
    if (inside || seen_end_on) {
      const touch where = touch_of(s, at);
      if (where.coverage > 0.0 && !(where.depth >= limits[VIEW.first_pixel + index_of(at)])) {
        any = true;
        visit(segment, at, where);
      }
    }
  }
}

/// Draws this invocation's segment, and says for the camera whether it is seen.
void draw_own_segment() {
  const uint i = invocation();
  if (i >= scene.segment_count) {
    return;
  }
  const uint segment = scene.shuffled ? drawing_order[i] : i;
  const bool any = draw(segment);
  if (is_camera()) {
    seen[first_point(segment)] = any ? 1u : 0u;
  }
}
#endif

#endif
