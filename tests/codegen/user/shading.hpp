// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/order/k_buffer.hpp>

#include <glm/vec3.hpp>

/// A user's header, over GLM and the library: pelage-glsl translates it too.
namespace fur {

/// What a strand looks like.
struct coat {
  glm::vec3 colour;
  float gloss;  ///< exponent of the highlight, [0, inf)
};

/// Light that a strand sends to the eye: pelage::kajiya_kay() of bsdf/kajiya_kay.hpp, and a sheen.
[[nodiscard]] inline glm::vec3 shade(const coat& c, const glm::vec3& tangent, const glm::vec3& to_light,
                                     const glm::vec3& to_eye) noexcept {
  const pelage::kajiya_kay_lobes lobes = pelage::kajiya_kay(tangent, to_light, to_eye, c.gloss);
  const float sheen = pelage::fresnel_dielectric(lobes.diffuse, 1.55f);
  return c.colour * lobes.diffuse + (sheen + lobes.specular);
}

/// The depth of the nearest fragment that a buffer holds.
template <std::uint32_t K>
[[nodiscard]] float nearest_depth(const pelage::k_buffer<K>& buffer_of_pixel) noexcept {
  float depth = buffer_of_pixel.slot[0].depth;
  for (std::uint32_t i = 1u; i < K; ++i) {
    depth = std::min(depth, buffer_of_pixel.slot[i].depth);
  }
  return depth;
}

/// True for a buffer that holds nothing.
template <std::uint32_t K>
[[nodiscard]] bool is_bare(const pelage::k_buffer<K>& buffer_of_pixel) noexcept {
  return buffer_of_pixel.size() == 0u;
}

}  // namespace fur
