// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/tail.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <glm/vec3.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// All fragments of a pixel as n equal ones of their mean colour and mean alpha. [Bavoil & Myers 2008, §4]
///
/// Keeps the alpha-weighted mean colour, the mean alpha and the number; drops the order, and takes (1 - mean)ⁿ for
/// the product of transmittances, which is less than the truth by rounding alone: at most n · 6e-7, since each alpha is
/// rounded by up to 2⁻²¹. Integer sums: any order of fragments gives the same bits. 24 bytes.
struct weighted_average {
  tail sums;            ///< as add_fragment() leaves it
  std::uint32_t count;  ///< fragments, stops at 2³² - 1

  /// A pixel with nothing in it.
  [[nodiscard]] static constexpr weighted_average empty() noexcept { return weighted_average{empty_tail(), 0u}; }

  /// Adds a fragment. Parameters as add_fragment() of a tail.
  void add(float alpha, const glm::vec3& colour) noexcept {
    sums = add_fragment(sums, alpha, colour);
    count = add_saturating(count, 1u);
  }

  /// Adds another pixel's part. Associative and commutative, empty() is the identity.
  constexpr void merge(const weighted_average& other) noexcept {
    sums = pelage::merge(sums, other.sums);
    count = add_saturating(count, other.count);
  }

  /// What passes all fragments, [0, 1]: (1 - Σ α / n)ⁿ, within n · 6e-7 for Σ α < 4096; 1 when there are none.
  [[nodiscard]] constexpr float transmittance() const noexcept {
    if (count == 0u) {
      return 1.0f;
    }
    const float number = static_cast<float>(count);
    const float mean = saturate(static_cast<float>(sums.weight) * (1.0f / 1048576.0f) / number);
    return fast_exp2(number * fast_log2(1.0f - mean));
  }

  /// What is seen of the pixel in front of a background.
  [[nodiscard]] glm::vec3 resolve(const glm::vec3& background) const noexcept {
    const float passed = transmittance();
    return mean_colour(sums) * (1.0f - passed) + background * passed;
  }
};

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
