// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/tail.hpp>
#include <pelage/core/assert.hpp>
#include <pelage/visibility/cell_storage.hpp>

#include <glm/vec3.hpp>

#include <atomic>
#include <cstdint>

namespace pelage {

/// What the blendings without sorting share: a tail whose colours are weighted by more than their alpha, which in the
/// end stand before the background as one layer. Its transmittance stays the exact product. Integer sums: any order of
/// fragments gives the same bits.

/// The tail with one more fragment of a weight of its own. `weight`: [0, 1] so that the sums reach 4096 fragments,
/// alpha included, to the nearest 2⁻²⁰; NaN counts as 0. `colour`: linear RGB, [0, inf]. `alpha`: clamped to [0, 1].
[[nodiscard]] constexpr tail add_weighted(const tail& t, float alpha, float weight, const glm::vec3& colour) noexcept;

/// What is seen of a tail before a background: its mean colour by weight over what it lets through. Black for the
/// fibres' part where no weight reaches 2⁻²¹. The scale by which the mean is put right is Λ = 1 - transmittance.
[[nodiscard]] constexpr glm::vec3 resolve(const tail& t, const glm::vec3& background) noexcept;

/// Puts a tail into a pixel that many threads fill at once: cells [5 · pixel, 5 · pixel + 5), all 0 at first.
/// Lock-free; memory orders: cell_storage.
template <cell_storage Storage>
void add_to_tail(Storage& storage, std::uint32_t pixel, const tail& added) noexcept;

/// A pixel of such a storage. Not concurrent with add_to_tail.
template <cell_storage Storage>
[[nodiscard]] tail load_tail(const Storage& storage, std::uint32_t pixel) noexcept;

// ---------------------------------------------------------------------------------------------------------

constexpr tail add_weighted(const tail& t, float alpha, float weight, const glm::vec3& colour) noexcept {
  const float held = weight > 0.0f ? weight : 0.0f;
  const tail one = tail{optical_depth(alpha), to_fixed(held), to_fixed(held * colour.x), to_fixed(held * colour.y),
                        to_fixed(held * colour.z)};
  return merge(t, one);
}

constexpr glm::vec3 resolve(const tail& t, const glm::vec3& background) noexcept {
  const float passed = transmittance_of(t);
  return mean_colour(t) * (1.0f - passed) + background * passed;
}

template <cell_storage Storage>
void add_to_tail(Storage& storage, std::uint32_t pixel, const tail& added) noexcept {
  PELAGE_ASSERT(pixel < storage.cell_count() / 5u);
  add_to_cell(storage, 5u * pixel, added.optical);
  add_to_cell(storage, 5u * pixel + 1u, added.weight);
  add_to_cell(storage, 5u * pixel + 2u, added.red);
  add_to_cell(storage, 5u * pixel + 3u, added.green);
  add_to_cell(storage, 5u * pixel + 4u, added.blue);
}

template <cell_storage Storage>
tail load_tail(const Storage& storage, std::uint32_t pixel) noexcept {
  return tail{storage.load_cell(5u * pixel, std::memory_order_relaxed),
              storage.load_cell(5u * pixel + 1u, std::memory_order_relaxed),
              storage.load_cell(5u * pixel + 2u, std::memory_order_relaxed),
              storage.load_cell(5u * pixel + 3u, std::memory_order_relaxed),
              storage.load_cell(5u * pixel + 4u, std::memory_order_relaxed)};
}

}  // namespace pelage
