// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <array>
#include <cstdint>

#include "frame/settings.hpp"
#include "frame/stage.hpp"

namespace pelage::frame::vulkan {

/// The constants of shaders/scene.glsl, laid out as std140 lays them out: there is their meaning.
struct scene_block {
  static constexpr std::size_t most_lights = 8;
  static constexpr std::size_t most_parts = 8;
  static constexpr std::size_t most_copies = 128;

  struct view_block {
    glm::vec3 right;
    float scale;
    glm::vec3 up;
    float near_plane;
    glm::vec3 back;
    std::uint32_t perspective;
    glm::vec3 eye;
    std::uint32_t first_pixel;
    glm::ivec2 size;
    float cone_base;
    float cone_slope;
    float reach;
    std::uint32_t first_place;
    std::uint32_t first_stamp;
    std::uint32_t stamp_count;
    std::uint32_t first_block;
    std::uint32_t first_opacity;
    std::uint32_t layers;
    float layer_first;
    float layer_width;
    float line_nearest;
    float line_bin;
    float line_last;
    std::uint32_t end_place;
    std::array<std::uint32_t, 3> unused;
  };
  struct light_block {
    glm::vec3 position;
    std::uint32_t kind;
    glm::vec3 direction;
    float cos_outer;
    glm::vec3 colour;
    float cos_inner;
  };
  struct ellipsoid_block {
    glm::vec3 centre;
    float unused0;
    glm::vec3 radii;
    float unused1;
  };
  struct copy_block {
    glm::vec2 at;
    float cosine;
    float sine;
  };
  struct sphere_block {
    glm::vec3 centre;
    float radius;
  };

  std::array<view_block, most_lights + 1> views;
  std::array<light_block, most_lights> lights;
  std::array<ellipsoid_block, most_parts> parts;
  glm::vec3 sky;
  std::uint32_t light_count;
  glm::vec3 centre;
  float radius;
  glm::vec3 skin;
  std::uint32_t part_count;
  glm::vec3 ground;
  float floor_height;
  float floor_clear;
  std::uint32_t has_floor;
  std::uint32_t shadows;
  std::uint32_t translucent;
  std::uint32_t antialias;
  std::uint32_t segment_count;
  float eta;
  float diffuse;
  glm::vec3 ambient;
  float specular;
  float exponent;
  std::uint32_t copy_count;
  std::array<std::uint32_t, 2> unused;
  std::array<copy_block, most_copies> copies;
  std::array<sphere_block, most_copies> bodies;
  std::array<sphere_block, most_copies / solids::cluster_size> clusters;
};
static_assert(sizeof(scene_block::view_block) == 144 && sizeof(scene_block::light_block) == 48 &&
              sizeof(scene_block::ellipsoid_block) == 32 && sizeof(scene_block) == 6416);

/// The constants of a frame; views[i].first_pixel and first_block count those of the views before. What depends on the
/// number of fragments is 0.
/// Throws std::runtime_error for more lights or opaque objects than the block holds.
[[nodiscard]] scene_block make_scene_block(const stage& set, const frame_settings& settings);

}  // namespace pelage::frame::vulkan
