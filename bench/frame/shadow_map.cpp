// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadow_map.hpp"

#include <pelage/core/math.hpp>

#include <limits>

namespace pelage::frame {
namespace {

constexpr float unit = 1.0F / 1048576.0F;  ///< of fixed-point sums, octaves or fibres

}  // namespace

shadow_map::shadow_map(const raster& from, const solids& opaque, bool translucent)
    : fibres_(from.fibres()),
      light_(from.from()),
      translucent_(translucent),
      limit_(opaque_depths(from.from(), opaque)),
      fibres_per_octave_(limit_.size(), 0.0F) {
}

std::optional<shadow_map::corners> shadow_map::corners_of(const glm::vec3& in_view) const {
  const glm::vec2 pixel = light_.to_pixel(in_view);
  const glm::vec2 size(static_cast<float>(light_.width), static_cast<float>(light_.height));
  if (!(pixel.x >= 0.0F && pixel.y >= 0.0F && pixel.x <= size.x && pixel.y <= size.y)) return std::nullopt;
  const glm::vec2 between = glm::clamp(pixel - 0.5F, glm::vec2(0.0F), size - 1.0F);  // the rim has its texel's value
  const glm::vec2 corner = glm::min(glm::floor(between), size - 2.0F);
  return corners{index(static_cast<int>(corner.x), static_cast<int>(corner.y)), between - corner};
}

/// The bilinear mean of what the four texels nearest to a position have at its depth.
template <class Value, class At>
Value shadow_map::mean(const glm::vec3& world, float bias, Value outside, At&& at) const {
  const glm::vec3 p = light_.to_view(world);
  const float depth = -p.z - bias;
  if (depth <= light_.near_plane) return outside;
  const auto found = corners_of(p);
  if (!found) return outside;
  const auto& [first, weight] = *found;
  const std::size_t below = first + static_cast<std::size_t>(light_.width);
  const Value top = glm::mix(at(first, depth), at(first + 1, depth), weight.x);
  const Value bottom = glm::mix(at(below, depth), at(below + 1, depth), weight.x);
  return glm::mix(top, bottom, weight.y);
}

void shadow_map::prefetch(const glm::vec3& world, int step) const {
  const auto found = corners_of(light_.to_view(world));
  if (!found) return;
  for (const std::size_t left : {found->first, found->first + static_cast<std::size_t>(light_.width)}) {
    if (step == 0) {
      __builtin_prefetch(&limit_[left]);
      __builtin_prefetch(&fibres_per_octave_[left]);
    }
    prefetch_texel(left, step);
    prefetch_texel(left + 1, step);
  }
}

float shadow_map::transmittance_to(const glm::vec3& world, float bias) const {
  return mean(world, bias, 1.0F, [this](std::size_t texel, float depth) {
    return depth > limit_[texel] ? 0.0F : fast_exp2(-optical_before(texel, depth) * unit);
  });
}

passage shadow_map::passed_to(const glm::vec3& world, float bias) const {
  const glm::vec3 passed = mean(world, bias, glm::vec3(1.0F, 0.0F, 1.0F), [this](std::size_t texel, float depth) {
    const bool hidden = depth > limit_[texel];
    const float octaves = optical_before(texel, hidden ? std::numeric_limits<float>::infinity() : depth) * unit;
    return glm::vec3(hidden ? 0.0F : fast_exp2(-octaves), octaves * fibres_per_octave_[texel], hidden ? 0.0F : 1.0F);
  });
  return {passed.x, passed.y, passed.z};
}

std::uint64_t shadow_map::bytes() const {
  return texel_bytes() + (limit_.size() + fibres_per_octave_.size()) * sizeof(float);
}

float shadow_map::texel_at(const glm::vec3& world) const {
  return 2.0F * radius_at(light_.cone, -light_.to_view(world).z);
}

float shadow_map::alpha(std::uint32_t segment, const touch& where) const {
  if (!translucent_) return where.coverage;
  const float opacity =
      fibres_.same_opacity ? *fibres_.same_opacity : fibres_.mix(fibres_.opacity, segment, where.along);
  return opacity * where.coverage;
}

seen_lanes::pack shadow_map::alpha(const seen_lanes& all) const {
  return translucent_ ? alpha_of(fibres_, all) : all.coverage;
}

void shadow_map::set_sums(std::size_t texel, std::uint32_t coverage, std::uint32_t optical) {
  fibres_per_octave_[texel] = optical > 0 ? static_cast<float>(coverage) / static_cast<float>(optical) : 0.0F;
}

}  // namespace pelage::frame
