// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "frame/stage.hpp"
#include "vulkan/device.hpp"

namespace pelage::frame::vulkan {

using pelage::vulkan::device;

/// The buffers of the shaders: what they hold is said where they are declared, in shaders/*.glsl.
enum binding : std::uint32_t {
  scene_buffer,
  point_buffer,
  tangent_buffer,
  colour_buffer,
  opacity_buffer,
  segment_buffer,
  record_buffer,
  limit_buffer,
  edge_buffer,
  count_buffer,
  run_buffer,
  pool_buffer,
  texel_buffer,
  entry_buffer,
  shaded_buffer,
  seen_buffer,
  picture_buffer,
  report_buffer,
  link_buffer,
  slot_buffer,
  cell_buffer,
  blended_buffer,
  stamp_buffer,
  block_limit_buffer,
  bsdf_buffer,
  covered_buffer,
  layer_buffer,
  rest_buffer,
  buffer_count
};

/// The words of shaders/scene.glsl's report of a view.
struct view_report {
  std::uint32_t fragments, longest, refused, taken, stamps, carries;

  /// All of a word that carries.
  [[nodiscard]] std::uint64_t with_carries(std::uint32_t word) const { return std::uint64_t{carries} << 32U | word; }
};

/// Uploads what does not change from frame to frame: the strands and the order of drawing them; without one, segments
/// that lie near each other are drawn together. `colour`: of all points, in the place of their own.
/// Throws std::runtime_error for more points than a segment's word can number.
void upload_fibres(device& to, const strands& fibres, std::span<const std::uint32_t> drawing_order,
                   const std::optional<glm::vec3>& colour);

/// Where the points of hair that moves rest.
void upload_rest(device& to, const swaying_hair& hair);

}  // namespace pelage::frame::vulkan
