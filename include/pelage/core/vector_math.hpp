// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/real_number.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace pelage::inline PELAGE_ABI {

/// Products and lengths of vectors as plain sums from x on: the bits of glm::dot and its like, on shaders' machines
/// too. A driver may fuse the built-in ones, which then leave 2e-8 of a × a and lose digits where sums cancel.

/// a · b.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline constexpr Real dot_product(const glm::vec<3, Real>& a,
                                                                    const glm::vec<3, Real>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a × b; exactly 0 for a × a.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline constexpr glm::vec<3, Real> cross_product(
    const glm::vec<3, Real>& a, const glm::vec<3, Real>& b) noexcept {
  return glm::vec<3, Real>(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
}

/// |v|, within 2 ulp where its square neither overflows nor underflows.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real vector_length(const glm::vec<3, Real>& v) noexcept {
  return square_root(dot_product(v, v));
}

/// v/|v|, a length of 1 within 2 ulp; 0 gives NaN.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline glm::vec<3, Real> unit_vector(const glm::vec<3, Real>& v) noexcept {
  return v * (Real(1) / square_root(dot_product(v, v)));
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
