// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/stochastic.hpp>
#include <pelage/composite/weighted_sum.hpp>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

#include "frame/order/layer.hpp"

namespace pelage::frame {

// What is seen of a pixel's layers before a background by methods that need no order: the same bits for every order.
// Each keeps as much as its structures in composite/ do, whatever the number of layers.

/// By the optical depth that an occupancy map of 128 slices over the pixel's own range estimates before each layer.
/// Exact where all alphas are equal and an empty slice lies
/// between any two layers.
[[nodiscard]] glm::vec3 blend_order_weighted(std::span<const layer> layers, const glm::vec3& background);

/// By mean colour and mean alpha. Exact where all layers are equal.
[[nodiscard]] glm::vec3 blend_weighted_average(std::span<const layer> layers, const glm::vec3& background);

/// By each layer's depth in the pixel's own range.
[[nodiscard]] glm::vec3 blend_weighted_blended(std::span<const layer> layers, const glm::vec3& background);

/// By the share of samples in which nothing lies before a layer. `stream`: stochastic_stream() of the pixel.
template <std::uint32_t Samples>
[[nodiscard]] glm::vec3 blend_stochastic(std::span<const layer> layers, const glm::vec3& background,
                                         std::uint32_t stream) {
  auto depths = stochastic_depths<Samples>::empty();
  for (const layer& l : layers)
    depths.add(l.where, l.alpha, stream);
  tail sum = empty_tail();
  for (const layer& l : layers)
    sum = add_weighted(sum, l.alpha, l.alpha * depths.transmittance_before(l.where.depth), l.radiance);
  return resolve(sum, background);
}

}  // namespace pelage::frame
