// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/optical_depth.hpp>
#include <pelage/composite/weighted_sum.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

namespace pelage::inline PELAGE_ABI {

/// Blending by an estimated order, without sorting: a fragment weighs (1 - α)ᵒ α, with o the number of fragments before
/// it, which a map (occupancy_map, opacity_map) estimates. [Sintorn & Assarsson 2009, §3.4] Add with add_weighted();
/// resolve() scales the sum by Λ = 1 - Π(1 - α), for equal alphas the paper's 1 - (1 - α)ⁿ. Exact (except for
/// rounding) where all alphas are equal and all orders right. Nothing may lie before a pixel's nearest fragment, or the
/// weights may be too small for a hue, none at all where it is opaque: look up interpolated_before_fragment() in a map
/// of the pixel's own depth range. The paper prints the correction as a/Λ, with a the accumulated alpha; what gives the
/// sum Σ of the weights, a, the size Λ that it must have is Λ/a.

/// The weight of a fragment behind `order` others of its own alpha, [0, 1]. `order`: [0, inf). `alpha`: clamped to
/// [0, 1]; where it is 1 only order 0 weighs anything, and below 2⁻²⁵ all orders weigh α. An alpha of NaN gives 0 or
/// NaN, an order of NaN gives NaN, or 1 where alpha is 1.
[[nodiscard]] constexpr float order_weight(float alpha, float order) noexcept {
  const float held = saturate(alpha);
  if (held >= 1.0f) {
    return order > 0.0f ? 0.0f : 1.0f;
  }
  return held * fast_exp2(order * fast_log2(1.0f - held));
}

/// The weight of a fragment behind an estimated optical depth, [0, 1]: for maps that sum optical_depth(alpha), and so
/// know of fragments whose alphas differ. `optical`: as for transmittance_of().
[[nodiscard]] constexpr float optical_weight(float alpha, float optical) noexcept {
  return saturate(alpha) * transmittance_of(optical);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
