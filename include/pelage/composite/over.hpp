// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/version.hpp>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// A colour and its alpha as a premultiplied one, (R α, G α, B α, α). `alpha`: [0, 1]. [Porter & Duff 1984; Svoboda
/// §2.5.2, where the text has R/α for R α]
template <std::floating_point Real>
[[nodiscard]] constexpr glm::vec<4, Real> premultiply(const glm::vec<3, Real>& colour, Real alpha) noexcept {
  return glm::vec<4, Real>(colour * alpha, alpha);
}

/// `front` over `back`, both premultiplied: what is seen of both. [Porter & Duff 1984] Associative except for rounding;
/// a transparent black is the identity. An opaque front hides any finite back.
template <std::floating_point Real>
[[nodiscard]] constexpr glm::vec<4, Real> over(const glm::vec<4, Real>& front, const glm::vec<4, Real>& back) noexcept {
  return front + (Real(1) - front.w) * back;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
