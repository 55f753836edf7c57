// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <array>
#include <cstdint>
#include <vector>

#include "frame/image/image.hpp"
#include "truth/lighting.hpp"

namespace pelage::truth {

/// sRGB of a linear value without rounding (IEC 61966-2-1), clamped to [0, 1].
[[nodiscard]] double encode(double linear);

/// What half of a pixel's rays saw, means over the rays.
struct half_pixel {
  glm::vec3 linear{0.0F};  ///< with shadows
  glm::vec3 full{0.0F};    ///< with shadows, sRGB
  glm::vec3 lit{0.0F};     ///< without shadows, sRGB
  float alpha = 0;         ///< what fibres hide of what is behind them
  float entries = 0;       ///< fibres met
};

/// A picture by rays, twice with independent rays: for any estimate P of the picture (P - A)(P - B) is its squared
/// error with no share of the rays' noise.
struct picture {
  int width = 0;
  int height = 0;
  std::array<std::vector<half_pixel>, 2> halves;
  std::vector<std::uint8_t> edge;  ///< 1 where rays of the pixel meet an opaque object and what lies behind its edge
};

/// `samples`: rays a pixel in each half, [2, inf). All fibres on a ray count in order, each by its opacity; what is
/// left below 1/5 is carried on by chance, unbiased. The encoded means are less their noise's bias, ½ f″ σ².
[[nodiscard]] picture see(const lighting& scene, int samples, std::uint64_t seed);

/// Alpha and entries alone, of the fibres without opaque objects.
[[nodiscard]] picture see_fibres(const frame::view& from, const fibre_rays& fibres, int samples, std::uint64_t seed);

/// The mean of both halves, linear.
[[nodiscard]] frame::image mean_of(const picture& p);

}  // namespace pelage::truth
