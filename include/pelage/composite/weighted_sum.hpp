// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/tail.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// What the blendings without sorting share: a tail whose colours are weighted by more than their alpha, which in the
/// end stand before the background as one layer. Its transmittance stays the exact product. Integer sums: any order of
/// fragments gives the same bits. Many threads fill a pixel at once through atomic_tail.

/// The tail with one more fragment of a weight of its own. `weight`: alpha included, to the nearest 2⁻²⁰, [0, 1] so
/// that the sums reach 4096 fragments; NaN counts as 0. `alpha` and `colour` as for add_fragment() of a tail, with Σ
/// weight in the place of Σ alpha.
[[nodiscard]] inline tail add_weighted(const tail& t, float alpha, float weight, const glm::vec3& colour) noexcept {
  const float held = weight > 0.0f ? weight : 0.0f;
  const glm::vec3 share = held * clamp_keeping_hue(colour);
  const tail one = tail{optical_depth(alpha), to_fixed(held), to_fixed(share.x), to_fixed(share.y), to_fixed(share.z)};
  return merge(t, one);
}

/// What is seen of a tail before a background: its mean colour by weight over what it lets through. Black for the
/// fibres' part where no weight reaches 2⁻²¹. The scale by which the mean is put right is Λ = 1 - transmittance.
[[nodiscard]] inline glm::vec3 resolve(const tail& t, const glm::vec3& background) noexcept {
  const float passed = transmittance_of(t);
  return mean_colour(t) * (1.0f - passed) + background * passed;
}

/// The sum as it is, without Λ: Σ weight · colour before a background, as blendings by an estimated visibility have it
/// [Yu12 Fig. 8's deep opacity maps]. Brighter or darker than the truth by as much as the weights' sum is off Λ.
[[nodiscard]] inline glm::vec3 resolve_unscaled(const tail& t, const glm::vec3& background) noexcept {
  const glm::vec3 sum(static_cast<float>(t.red), static_cast<float>(t.green), static_cast<float>(t.blue));
  return sum * (1.0f / 1048576.0f) + background * transmittance_of(t);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
