// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/buffers.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace pelage::frame::vulkan {
namespace {

// As in shaders/scene.glsl.
constexpr std::uint32_t begins_strand = 0x80000000U;
constexpr std::uint32_t ends_strand = 0x40000000U;

template <class Values>
void upload_all(device& to, std::uint32_t binding, const Values& values) {
  to.resize(binding, values.size() * sizeof(values[0]));
  to.upload(binding, std::as_bytes(std::span(values)));
}

/// The bits of x in [0, 1024) with two zeros between each and the next.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16U) & 0x030000ffU;
  x = (x | x << 8U) & 0x0300f00fU;
  x = (x | x << 4U) & 0x030c30c3U;
  return (x | x << 2U) & 0x09249249U;
}

/// A place's number along the Z curve through the box.
std::uint32_t z_order(const glm::vec3& p, const glm::vec3& lower, const glm::vec3& size) {
  const glm::vec3 unit = (p - lower) / glm::max(size, glm::vec3(1e-30F));
  const glm::uvec3 cell(glm::clamp(unit * 1024.0F, 0.0F, 1023.0F));
  return spread(cell.x) | spread(cell.y) << 1U | spread(cell.z) << 2U;
}

/// Segments that lie near each other side by side, of whichever strand: the invocations of a subgroup draw to the same
/// few pixels, and what they load and store lies together.
std::vector<std::uint32_t> drawn_together(const strands& fibres) {
  glm::vec3 lower(std::numeric_limits<float>::infinity());
  glm::vec3 upper(-std::numeric_limits<float>::infinity());
  for (const glm::vec3& p : fibres.point) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  std::vector<std::uint32_t> key(fibres.segment_count());
  for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
    const std::uint32_t i = fibres.segment[s];
    key[s] = z_order(0.5F * (fibres.point[i] + fibres.point[i + 1]), lower, upper - lower);
  }
  std::vector<std::uint32_t> order(fibres.segment_count());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  return order;
}

}  // namespace

void upload_fibres(device& to, const strands& fibres, std::span<const std::uint32_t> drawing_order,
                   const std::optional<glm::vec3>& colour) {
  const std::size_t count = fibres.point.size();
  if (count >= ends_strand) throw std::runtime_error("--device vulkan: the model has more than 2^30 points");
  std::vector<glm::vec4> points(count);
  for (std::size_t i = 0; i < count; ++i)
    points[i] = glm::vec4(fibres.point[i], fibres.radius[i]);
  const std::vector<std::uint32_t> together =
      drawing_order.empty() ? drawn_together(fibres) : std::vector<std::uint32_t>();
  const std::span<const std::uint32_t> order = drawing_order.empty() ? std::span(together) : drawing_order;
  std::vector<std::uint32_t> segments(order.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::uint32_t i = fibres.segment[order[s]];
    segments[s] = i;
    if ((fibres.end_of[i] & strands::first) != 0) segments[s] |= begins_strand;
    if ((fibres.end_of[i + 1] & strands::last) != 0) segments[s] |= ends_strand;
  }
  upload_all(to, point_buffer, points);
  upload_all(to, tangent_buffer, fibres.tangent);
  if (colour) {
    upload_all(to, colour_buffer, std::vector<glm::vec3>(count, *colour));
  } else {
    upload_all(to, colour_buffer, fibres.colour);
  }
  upload_all(to, opacity_buffer, fibres.opacity);
  upload_all(to, segment_buffer, segments);
}

void upload_rest(device& to, const swaying_hair& hair) {
  static_assert(sizeof(rest_point) == 16);  // as in shaders/sway.comp
  upload_all(to, rest_buffer, hair.rest);
}

}  // namespace pelage::frame::vulkan
