// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <array>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// What moments leave open, in units of optical_depth(): each distribution of optical depth that has them holds an
/// amount in [least, most] before a depth, and each end is some distribution's. [Münstermann et al. 2018]
struct moment_bounds {
  float least;  ///< before the depth
  float most;   ///< before the depth and at it
};

/// The middle of the bounds, as the estimate of what lies before a depth. The paper takes a quarter.
[[nodiscard]] constexpr float middle_of(const moment_bounds& bounds) noexcept {
  return bounds.least + 0.5f * (bounds.most - bounds.least);
}

/// The same for a fragment that is in the sums itself: its own amount lies at the depth, and so not before it, which
/// lowers the upper bound. Exact where nothing else lies there. The paper lets a fragment shadow itself.
[[nodiscard]] constexpr float middle_of_others(const moment_bounds& bounds, std::uint32_t own) noexcept {
  const float others = bounds.most - bounds.least - static_cast<float>(own);
  return bounds.least + 0.5f * (others > 0.0f ? others : 0.0f);
}

/// The part (1 + m) / 2 of an amount, [0, amount], that sums a moment m in [-1, 1] as a natural number: to the nearest
/// within 1 + 2⁻²² amount. Moments beyond by rounding are clamped; NaN counts as -1.
[[nodiscard]] constexpr std::uint32_t moment_part(std::uint32_t amount, float moment) noexcept {
  const float part = static_cast<float>(amount) * saturate(0.5f + 0.5f * moment) + 0.5f;
  const std::uint32_t whole = part < 4294967040.0f ? static_cast<std::uint32_t>(part) : 0xffffffffu;
  return whole < amount ? whole : amount;
}

/// The mean moment, [-1, 1], of a sum of moment_part() over that of the amounts, [1, 2³²).
[[nodiscard]] constexpr float mean_moment(std::uint32_t parts, std::uint32_t amounts) noexcept {
  return 2.0f * saturate(static_cast<float>(parts) / static_cast<float>(amounts)) - 1.0f;
}

/// Mean moments are scaled by this, (0, 1), so that rounding leaves them those of some distribution: it mixes 2⁻¹⁹ of
/// one without gaps, whose moments are 0, into them, and 8 units, for the rounding of the sums. [ibid.] `amounts` as in
/// mean_moment().
[[nodiscard]] constexpr float unbiased_share(std::uint32_t amounts) noexcept {
  return 1.0f - (1.9073486e-6f + 8.0f / (8.0f + static_cast<float>(amounts)));
}

/// The share of variance that the next moments may leave, below which they are noise and are left out.
[[nodiscard]] constexpr float moment_noise() noexcept {
  return 1e-4f;
}

/// x clamped to [2⁻¹⁹, 1]; NaN gives the lower end.
[[nodiscard]] constexpr float clamp_moment_ratio(float x) noexcept {
  return x > 1.9073486e-6f ? (x < 1.0f ? x : 1.0f) : 1.9073486e-6f;
}

/// The roots of y³ + c2 y² + c1 y + c0, all of which are real, in no order; where rounding made two of them complex,
/// their real part twice. With c0 = 0 one is 0 and the others are those of y² + c2 y + c1.
[[nodiscard]] inline std::array<float, 3> real_roots(float c2, float c1, float c0) noexcept;

// ---------------------------------------------------------------------------------------------------------

inline std::array<float, 3> real_roots(float c2, float c1, float c0) noexcept {
  // Viète's form is accurate for the root of greatest magnitude, an end of the three; what it leaves is a quadratic.
  const float middle = -c2 / 3.0f;
  const float q = (c2 * c2 - 3.0f * c1) / 9.0f;
  const float r = (2.0f * c2 * c2 * c2 - 9.0f * c2 * c1 + 27.0f * c0) / 54.0f;
  const float reach = 2.0f * safe_sqrt(q);
  const float angle = unsigned_angle(safe_sqrt(q * q * q - r * r), -r) / 3.0f;
  const float right = middle + reach * rotation_by(angle).cosine;
  const float left = middle - reach * rotation_by(1.04719755f - angle).cosine;
  const float first = absolute(right) > absolute(left) ? right : left;
  std::array<float, 3> root = {first, 0.0f, 0.0f};
  if (absolute(first) > 1e-12f) {
    const float product = -c0 / first;
    const float half_sum = 0.5f * ((c1 - product) / first);
    const float apart = safe_sqrt(half_sum * half_sum - product);
    root[1] = half_sum > 0.0f ? half_sum + apart : half_sum - apart;
    root[2] = absolute(root[1]) > 1e-12f ? product / root[1] : 0.0f;
  }
  return root;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
