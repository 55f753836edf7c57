// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/weighted_sum.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

namespace pelage::inline PELAGE_ABI {

/// Weighted, blended order-independent transparency [McGuire & Bavoil 2013]: a fragment weighs by its depth alone, by
/// no estimate of what lies before it. Add with add_weighted(), resolve() as there.

/// The weight of a fragment in its pixel's depth range, [3.3e-6, 1] times alpha: α max(10⁻², 3·10³ (1 - z)³) [McGuire &
/// Bavoil 2013, Eq. 10] over 3·10³, so that fixed-point sums hold it; the mean does not see the scale. `relative` z:
/// depth_range::relative of the pixel, whose nearest fragment then weighs α: over a wider range, far pixels would lose
/// their hue to the sums' 2⁻²¹ a fragment (see distance_weight). NaN counts as 0.
[[nodiscard]] constexpr float depth_weight(float alpha, float relative) noexcept {
  const float left = 1.0f - saturate(relative);
  const float weight = left * left * left;
  const float least = 3.33333333e-6f;
  return saturate(alpha) * (weight > least ? weight : least);
}

/// The weight of a fragment in a depth range of the whole scene: α 2^(-halvings · z), [2^-halvings, 1] times alpha.
/// `relative` z: [0, 1], 0 nearest; NaN counts as 0. `halvings`: [0, 8], how often the weight halves over the range; at
/// 0 all depths weigh the same. Wherever in the range a pixel lies, its mean colour is right within
/// 2^(halvings - 20) / α for colours up to white.
[[nodiscard]] constexpr float distance_weight(float alpha, float relative, float halvings) noexcept {
  return saturate(alpha) * fast_exp2(-halvings * saturate(relative));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
