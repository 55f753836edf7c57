// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A segment's fragments in a view, exact coverage included, as bench/frame/raster.hpp has it. A shader that draws
// segments defines PELAGE_FRAME_DRAWS before the include, and behind it what becomes of a fragment of the segment that
// begins at point i:
//   void visit(uint i, uint pixel, touch where)
// or, with PELAGE_FRAME_CANDIDATES, of a pixel that the segment may touch; few of these it does not:
//   void visit(uint pixel)
#ifndef PELAGE_FRAME_RASTER_GLSL
#define PELAGE_FRAME_RASTER_GLSL
#include "pelage/glsl/composite/optical_depth.glsl"
#include "pelage/glsl/coverage/closest_points.glsl"
#include "pelage/glsl/coverage/disc_strip.glsl"
#include "projection.glsl"

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

precise placed_segment place(uint i) {
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

#ifdef PELAGE_FRAME_DRAWS
#ifdef PELAGE_FRAME_CANDIDATES
void visit(uint pixel);
#else
void visit(uint i, uint pixel, touch where);
#endif

vec2 drawn_opacity;  ///< at the two ends of the segment that is being drawn for a light

/// What is kept of a fragment in the view: the camera's is found again by its segment's first point, a number that
/// orders as the segment's; a light needs the optical depth alone, and fragments that have depth and optical depth in
/// common are alike.
precise pelage_fragment fragment_of(uint i, touch where) {
  if (is_camera()) {
    return pelage_fragment(where.depth, i);
  }
  const float opacity = drawn_opacity.x + where.along * (drawn_opacity.y - drawn_opacity.x);
  return pelage_fragment(where.depth, pelage_optical_depth(opacity * where.coverage));
}

/// How far a pixel's centre lies past a joint along the strand, in units of no use but the sign.
precise float past(vec2 centre, vec2 joint, vec2 strand) {
  return dot(centre - joint, strand);
}

/// Twice the area between a pixel's centre and an edge.
precise float area(vec2 centre, vec2 start, vec2 edge) {
  return (centre.x - start.x) * edge.y - (centre.y - start.y) * edge.x;
}

/// How far beside the axis, in pixels, the centre of a pixel may lie that the fibre touches. A ray that passes a point
/// of the axis, z deep, at distance d passes it on the screen within d |u| scale / z, where u is the ray's direction;
/// the pixel's disc is half a pixel wide where the ray is z deep, and d |u| / 2 z wider where it is nearest.
precise float reach(float radius, float depth) {
  const vec2 corner = (0.5 * vec2(VIEW.size) + 0.5) / VIEW.scale;
  const float slant = VIEW.perspective ? sqrt(1.0 + dot(corner, corner)) : 1.0;
  const float fibre = VIEW.perspective ? radius * VIEW.scale / depth : radius * VIEW.scale;
  return 1.001 * slant * (fibre + 0.5) / (1.0 - 0.5 * slant * VIEW.cone_slope) + 0.01;
}

/// How far past its end, in shares of reach(), pixels on a segment's side of a joint's line reach along the walk:
/// the line leans by the walk's angle with the axis and the axis's angle with the strand.
precise float past_end(vec2 axis, vec2 strand, float sine, float cosine) {
  const float along = dot(axis, strand);
  const float across = abs(axis.x * strand.y - axis.y * strand.x);
  return along > across ? min(sine + cosine * across / along, 1.0) : 1.0;
}

/// Draws the segment that begins at a point. True if it left a fragment.
///
/// Pixels are walked along the longer side of the screen's rectangle round the axis, and of each column those whose
/// centres are within reach. What a candidate fails cheaply is tested first, so that lanes that go on to the coverage
/// do so together.
bool draw(uint word) {
  const uint i = word & point_mask;
  const placed_segment s = place(i);
#ifndef PELAGE_FRAME_CANDIDATES
  drawn_opacity = scene.translucent && !is_camera() ? vec2(opacities[i], opacities[i + 1u]) : vec2(1.0);
#endif
  const float near_depth = min(-s.start.z, -s.end.z);
  if (max(-s.start.z, -s.end.z) < VIEW.near_plane) {
    return false;
  }
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
  const bool bounded = near_depth >= VIEW.near_plane;  // else it may be anywhere
  const float side = bounded ? reach(widest, near_depth) : 1e9;
  const vec2 axis = end - start;
  const bool upright = abs(axis.y) > abs(axis.x);
  const ivec2 size = upright ? VIEW.size.yx : VIEW.size;  // from here on x is along the walk
  const vec2 from = upright ? start.yx : start;
  const vec2 way = upright ? axis.yx : axis;
  const float slope = way.x != 0.0 ? way.y / way.x : 0.0;
  const float half_height = side * sqrt(1.0 + slope * slope);
  const bool a_point = way.x == 0.0;
  const float size_of_axis = length(axis);
  const float sine = a_point ? 1.0 : abs(way.y) / size_of_axis;
  const float cosine = a_point ? 0.0 : abs(way.x) / size_of_axis;
  const float start_past = side * past_end(axis, start_joint, sine, cosine);
  const float end_past = side * past_end(axis, end_joint, sine, cosine);
  const float left = way.x < 0.0 ? from.x + way.x - end_past : from.x - start_past;
  const float right = way.x < 0.0 ? from.x + start_past : from.x + way.x + end_past;
  const float farthest_aside = side * size_of_axis;
  const int last = int(floor(clamp(right - 0.5, -1.0, float(size.x - 1))));
  const int height = int(clamp(floor(2.0 * half_height) + 1.0, 1.0, float(size.y)));
  // No ray is nearer to the axis than the nearest end by more than fibre and disc are wide.
  const float least_depth = near_depth - 2.0 * (widest + pelage_radius_at(cone_of(push.view), near_depth));

  ivec2 walk = ivec2(int(ceil(clamp(left - 0.5, 0.0, float(size.x)))) - 1, 0);
  int row = height;
  bool any = false;
  for (;;) {
    uint pixel;
    ivec2 at;
    float limit;
    bool candidate = false;
    do {
      if (row == height) {
        if (++walk.x > last) {
          return any;
        }
        row = 0;
        const float middle = from.y + (float(walk.x) + 0.5 - from.x) * slope;
        walk.y = bounded ? int(ceil(clamp(middle - half_height - 0.5, -1.0, float(size.y)))) : 0;
      }
      const int y = walk.y + row++;
      at = upright ? ivec2(y, walk.x) : ivec2(walk.x, y);
      const vec2 centre = vec2(at) + 0.5;
      const bool inside = past(centre, start, start_joint) >= 0.0 && past(centre, end, end_joint) < 0.0;
      candidate = y >= 0 && y < size.y && (inside || seen_end_on) &&
                  (!bounded || a_point || abs(area(centre, start, axis)) <= farthest_aside);
      if (candidate) {
        pixel = index_of(at);
        limit = limits[VIEW.first_pixel + pixel];
        candidate = !(least_depth >= limit);
      }
    } while (!candidate);
#ifdef PELAGE_FRAME_CANDIDATES
    visit(pixel);
#else
    const touch where = touch_of(s, at);
    if (where.coverage > 0.0 && !(where.depth >= limit)) {
      any = true;
      visit(i, pixel, where);
    }
#endif
  }
}

/// Draws this invocation's segment, and says for the camera whether it is seen.
void draw_own_segment() {
  const uint i = invocation();
  if (i >= scene.segment_count) {
    return;
  }
  const uint word = segments[i];
  const bool any = draw(word);
#ifndef PELAGE_FRAME_CANDIDATES
  if (is_camera()) {
    seen[word & point_mask] = any ? 1u : 0u;
  }
#endif
}
#endif

#endif
