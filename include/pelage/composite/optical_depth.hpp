// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <cstdint>
#include <type_traits>

namespace pelage::inline PELAGE_ABI {

/// Transmittances multiply; their logarithms add; and integers add to the same sum in any order. An optical depth
/// here is -log₂ of a transmittance in units of 2⁻²⁰, unsigned 32-bit. [Sintorn & Assarsson 2009, §3.3] counts o
/// fragments, takes e^(-o w) and leaves the weight w free; -log₂(1 - α) a fragment in its place makes the product
/// exact.
///
/// Range [0, 4096) octaves. One fragment counts at most 32 octaves (an opaque one). Sums saturate at the end of the
/// range, which is still the same in any order, and read as 0, as does every sum from 126.00001 octaves on. Each
/// fragment rounds by at most 2⁻²¹ octaves, a relative error of 3.4e-7 in the product; fast_log2 adds its own, 1e-7
/// octaves or 1e-7 of them, and 1 - alpha up to 9e-8. `alpha`: clamped to [0, 1]; NaN counts as 0.
template <single_precision Real>
[[nodiscard, gnu::always_inline]] inline constexpr natural_of<Real> optical_depth(Real alpha) noexcept;

/// x in units of 2⁻²⁰, rounded to the nearest within 2⁻²⁵ of a unit; 0 for negative and NaN, the greatest number from
/// 4096 on.
template <single_precision Real>
[[nodiscard, gnu::always_inline]] inline constexpr natural_of<Real> to_fixed(Real x) noexcept;

/// The transmittance of a sum, [0, 1]; exactly 1 for 0. Relative error below 1e-7 · (1 + octaves / 2) up to
/// 126 octaves.
[[nodiscard]] constexpr float transmittance_of(std::uint32_t optical) noexcept {
  return fast_exp2(-static_cast<float>(optical) * (1.0f / 1048576.0f));
}

/// The same for an estimate of a sum, such as the amount_before() of a map. `optical`: in units of 2⁻²⁰ octaves,
/// [0, inf]; a negative one and NaN count as 0.
[[nodiscard]] constexpr float transmittance_of(float optical) noexcept {
  return fast_exp2(-(optical > 0.0f ? optical : 0.0f) * (1.0f / 1048576.0f));
}

/// Other numbers are refused: one in octaves, or of 64 bits, would silently become units.
template <class Number>
requires std::is_arithmetic_v<Number>
float transmittance_of(Number optical) = delete;

// ---------------------------------------------------------------------------------------------------------

template <single_precision Real>
constexpr natural_of<Real> optical_depth(Real alpha) noexcept {
  const Real octaves = Real(0.0f) - fast_log2(Real(1.0f) - saturate(alpha));
  return to_fixed(select(octaves < Real(32.0f), octaves, Real(32.0f)));
}

template <single_precision Real>
constexpr natural_of<Real> to_fixed(Real x) noexcept {
  const Real positive = select(x > Real(0.0f), x, Real(0.0f));
  if (holds_for_all(positive < Real(8.0f))) {
    return to_natural(positive * Real(1048576.0f) + Real(0.5f));
  }
  // From 2²³ units on a float is a whole number, and adding a half would round to even.
  const Real units = select(positive < Real(4096.0f), positive, Real(0.0f)) * Real(1048576.0f);
  const Real rounded = select(positive < Real(8.0f), units + Real(0.5f), units);
  return select(positive < Real(4096.0f), to_natural(rounded), natural_of<Real>(0xffffffffu));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
