// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/scene_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pelage::frame::vulkan {
namespace {

glm::vec3 row(const glm::mat3& m, int i) {
  return {m[0][i], m[1][i], m[2][i]};
}

/// A ray that passes a point of a fibre's axis, z deep, at distance d passes it on the screen within d |u| scale / z,
/// where u is the ray's direction; where the ray is nearest, the pixel's disc is wider than z deep by at most its slope
/// times d |u| / 2. So pixels within this times (the fibre's radius and the disc's, in pixels) are all that a fibre
/// touches; where a disc may be wider than the ray is long, all pixels.
float reach_of(const view& v) {
  if (!v.perspective) return 1.001F;
  const glm::vec2 corner = (0.5F * glm::vec2(v.width, v.height) + 0.5F) / v.scale;
  const float slant = std::sqrt(1.0F + glm::dot(corner, corner));
  return 1.001F * slant / std::max(1.0F - 0.5F * slant * v.cone.slope, 1e-6F);
}

/// Blocks of shaders/scene.glsl.
std::uint32_t blocks_of(const view& v) {
  return static_cast<std::uint32_t>((v.width + 7) / 8 * ((v.height + 7) / 8));
}

scene_block::view_block block_of(const view& v, std::uint32_t first_pixel, std::uint32_t first_block) {
  scene_block::view_block b{};
  b.right = row(v.rotation, 0);
  b.scale = v.scale;
  b.up = row(v.rotation, 1);
  b.near_plane = v.near_plane;
  b.back = row(v.rotation, 2);
  b.perspective = v.perspective ? 1 : 0;
  b.eye = v.eye;
  b.first_pixel = first_pixel;
  b.first_block = first_block;
  b.size = {v.width, v.height};
  b.cone_base = v.cone.base;
  b.cone_slope = v.cone.slope;
  b.reach = reach_of(v);
  return b;
}

scene_block::light_block block_of(const light& l) {
  return {l.position, static_cast<std::uint32_t>(l.kind), l.direction, l.cos_outer, l.colour, l.cos_inner};
}

}  // namespace

scene_block make_scene_block(const stage& set, const frame_settings& settings) {
  if (set.lights.size() > scene_block::most_lights) {
    throw std::runtime_error(fmt::format("--device vulkan: at most {} lights", scene_block::most_lights));
  }
  if (set.opaque.parts.size() > scene_block::most_parts) {
    throw std::runtime_error(fmt::format("--device vulkan: at most {} opaque objects", scene_block::most_parts));
  }
  if (set.opaque.copies.size() > scene_block::most_copies) {
    throw std::runtime_error(fmt::format("--device vulkan: a crowd of at most {} copies", scene_block::most_copies));
  }
  scene_block b{};
  std::uint32_t pixels = 0;
  std::uint32_t blocks = 0;
  for (std::size_t i = 0; i < set.lights.size(); ++i) {
    b.lights[i] = block_of(set.lights[i]);
    b.views[i] = block_of(set.light_views[i], pixels, blocks);
    pixels += static_cast<std::uint32_t>(set.light_views[i].width * set.light_views[i].height);
    blocks += blocks_of(set.light_views[i]);
  }
  b.views[set.lights.size()] = block_of(set.eye, pixels, blocks);
  if (settings.drawn == primitive::line) {
    for (std::size_t i = 0; i <= set.lights.size(); ++i) {
      const line_depths lines = line_depths_of(set, i < set.lights.size() ? set.light_views[i] : set.eye);
      scene_block::view_block& v = b.views[i];
      v.line_nearest = lines.nearest;
      v.line_bin = lines.bin;
      v.line_last = lines.last;
      v.reach *= lines.widening;
    }
  }
  for (std::size_t i = 0; i < set.opaque.parts.size(); ++i)
    b.parts[i] = {set.opaque.parts[i].centre, 0.0F, set.opaque.parts[i].radii, 0.0F};
  b.copy_count = static_cast<std::uint32_t>(set.opaque.copies.size());
  for (std::size_t i = 0; i < set.opaque.copies.size(); ++i) {
    b.copies[i] = {set.opaque.copies[i].at, set.opaque.copies[i].cosine, set.opaque.copies[i].sine};
    b.bodies[i] = {set.opaque.bodies[i].centre, set.opaque.bodies[i].radius};
  }
  for (std::size_t i = 0; i < set.opaque.clusters.size(); ++i)
    b.clusters[i] = {set.opaque.clusters[i].centre, set.opaque.clusters[i].radius};
  b.sky = set.sky;
  b.light_count = static_cast<std::uint32_t>(set.lights.size());
  b.centre = set.round.centre;
  b.radius = set.round.radius;
  b.skin = set.opaque.skin;
  b.part_count = static_cast<std::uint32_t>(set.opaque.parts.size());
  b.ground = set.opaque.ground;
  b.floor_height = set.opaque.floor.value_or(0.0F);
  b.floor_clear = set.opaque.clear;
  b.has_floor = set.opaque.floor ? 1 : 0;
  b.shadows = has_shadows(settings.shown) ? 1 : 0;
  b.translucent = has_translucency(settings.shown) ? 1 : 0;
  b.antialias = settings.antialias ? 1 : 0;
  b.segment_count = set.fibres.segment_count();
  if (settings.look.passing == attenuation::fresnel) {
    b.eta = settings.look.eta;
    for (std::size_t v = 0; v <= set.lights.size(); ++v)
      b.views[v].first_opacity = static_cast<std::uint32_t>(v * set.fibres.point.size());
  }
  b.diffuse = settings.look.diffuse;
  b.specular = settings.look.specular;
  b.ambient = settings.ambient;
  b.exponent = settings.look.exponent;
  return b;
}

}  // namespace pelage::frame::vulkan
