// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/version.hpp>

#include <glm/vec3.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// What one fibre lets through to what lies behind it, per channel: A C + (1 - C). [Yu12 §3.1, Eq. 3]
/// The transmittance of a path is the product over its fibres, in any order.
///
/// `attenuation` A: the part of the light that passes where the fibre is hit, [0, 1]; 1 - opacity for a grey fibre.
/// `coverage` C: the share of the pixel that it covers, [0, 1]. A = 1 or C = 0 gives exactly 1, C = 1 exactly A.
template <std::floating_point Real>
[[nodiscard]] constexpr glm::vec<3, Real> transmittance(const glm::vec<3, Real>& attenuation, Real coverage) noexcept {
  return attenuation * coverage + (Real(1) - coverage);
}

/// The same for a grey attenuation.
template <std::floating_point Real>
[[nodiscard]] constexpr Real transmittance(Real attenuation, Real coverage) noexcept {
  return attenuation * coverage + (Real(1) - coverage);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
