// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <concepts>

namespace pelage {

/// Products and lengths of vectors as plain sums from x on: the bits of glm::dot and its like, on shaders' machines
/// too. A driver may fuse the built-in ones, which then leave 2e-8 of a × a and lose digits where sums cancel.

/// a · b.
template <std::floating_point Real>
[[nodiscard]] constexpr Real dot_product(const glm::vec<3, Real>& a, const glm::vec<3, Real>& b) noexcept;

/// a × b; exactly 0 for a × a.
template <std::floating_point Real>
[[nodiscard]] constexpr glm::vec<3, Real> cross_product(const glm::vec<3, Real>& a,
                                                        const glm::vec<3, Real>& b) noexcept;

/// |v|, within 2 ulp where its square neither overflows nor underflows.
template <std::floating_point Real>
[[nodiscard]] Real vector_length(const glm::vec<3, Real>& v) noexcept;

/// v/|v|, a length of 1 within 2 ulp; 0 gives NaN.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> unit_vector(const glm::vec<3, Real>& v) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
constexpr Real dot_product(const glm::vec<3, Real>& a, const glm::vec<3, Real>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <std::floating_point Real>
constexpr glm::vec<3, Real> cross_product(const glm::vec<3, Real>& a, const glm::vec<3, Real>& b) noexcept {
  return glm::vec<3, Real>(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
}

template <std::floating_point Real>
Real vector_length(const glm::vec<3, Real>& v) noexcept {
  return std::sqrt(dot_product(v, v));
}

template <std::floating_point Real>
glm::vec<3, Real> unit_vector(const glm::vec<3, Real>& v) noexcept {
  return v * (Real(1) / std::sqrt(dot_product(v, v)));
}

}  // namespace pelage
