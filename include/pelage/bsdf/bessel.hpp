// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

#include <cmath>
#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// I₀(x) = value · e^growth, the modified Bessel function of the first kind without its overflow. The growth is x or
/// 0, so that it can be added to an exponent that cancels it before anything is exponentiated.
template <real_number Real>
struct bessel_i0_parts {
  Real value;   ///< (0, 68) in float, (0, 5e7) in double
  Real growth;  ///< 0 for small arguments, x for large ones
};

/// I₀ at x ≥ 0, +inf excepted; relative error of the value below 3e-7 in float, 3e-15 in double.
///
/// In float: a polynomial in x² up to 6, beyond it one in 1/x of √x e⁻ˣ I₀. In double: the power series, whose terms
/// are all positive, up to 20, beyond it the asymptotic series, whose least term is then below e⁻⁴⁰.
/// [Abramowitz & Stegun 9.6.12, 9.7.1]
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline bessel_i0_parts<Real> bessel_i0(Real x) noexcept;

/// ln I₀(x), x in [0, +inf): relative error below 1e-6 in float, 1e-14 in double, near 0 (x²/4) as elsewhere, as long
/// as it is normal.
template <std::floating_point Real>
[[nodiscard]] inline Real log_bessel_i0(Real x) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// The series in double: I₀ - 1 for x ≤ 20.
template <std::floating_point Real>
[[nodiscard]] inline Real bessel_i0_series(Real x) noexcept {
  const Real quarter = Real(0.25) * x * x;
  Real term = quarter;
  Real sum = quarter;
  for (int k = 2; k <= 60; ++k) {
    term *= quarter / (Real(k) * Real(k));
    sum += term;
  }
  return sum;
}

/// The asymptotic series in double: e⁻ˣ I₀ for x ≥ 20.
template <std::floating_point Real>
[[nodiscard]] inline Real bessel_i0_tail(Real x) noexcept {
  Real term = Real(1);
  Real sum = Real(1);
  for (int k = 1; k <= 30; ++k) {
    term *= Real((2 * k - 1) * (2 * k - 1)) / (Real(8 * k) * x);
    sum += term;
  }
  return sum / std::sqrt(Real(6.283185307179586477) * x);
}

/// I₀ - 1 over x² in float, x² ≤ 36.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real bessel_i0_rise(Real square) noexcept {
  const Real s2 = square * square;
  const Real top = Real(8.05699179e-15f) + Real(4.52113265e-17f) * square;
  const Real high = Real(4.69433437e-10f) + Real(2.46096026e-12f) * square;
  const Real middle = Real(6.78144761e-06f) + Real(6.78411567e-08f) * square;
  const Real low = Real(0.0156249963f) + Real(0.000434029091f) * square;
  return Real(0.25f) + square * ((low + s2 * middle) + s2 * s2 * (high + s2 * top));
}

}  // namespace detail

template <real_number Real>
bessel_i0_parts<Real> bessel_i0(Real x) noexcept {
  if constexpr (std::floating_point<Real> && sizeof(Real) > 4) {
    const bool small = x < Real(20);
    return bessel_i0_parts<Real>{small ? Real(1) + detail::bessel_i0_series(x) : detail::bessel_i0_tail(x),
                                 small ? Real(0) : x};
  } else {
    const Real bounded = least(x, Real(6.0f));
    const Real square = bounded * bounded;
    const Real near = detail::bessel_i0_rise(square) * square + Real(1.0f);
    const Real t = Real(1.0f) / greatest(x, Real(6.0f));
    const Real high = Real(0.602922142f) * t + Real(-0.0839143246f);
    const Real middle = Real(0.041742567f) * t + Real(0.0275332332f);
    const Real p = (Real(0.0498753674f) * t + Real(0.398942262f)) + t * t * (middle + t * t * high);
    const Real far = p * square_root(t);
    return bessel_i0_parts<Real>{select(x < Real(6.0f), near, far), select(x < Real(6.0f), Real(0.0f), x)};
  }
}

template <std::floating_point Real>
Real log_bessel_i0(Real x) noexcept {
  if constexpr (sizeof(Real) > 4) {
    return x < Real(20) ? std::log1p(detail::bessel_i0_series(x)) : x + std::log(detail::bessel_i0_tail(x));
  } else {
    // ln(1 + r) = ln(1 + r rounded) + what the rounding lost, or r itself where nothing is left of it.
    const Real rise = detail::bessel_i0_rise(x * x) * x * x;
    const Real sum = 1.0f + rise;
    const bessel_i0_parts<Real> parts = bessel_i0(x);
    const Real far = natural_logarithm(parts.value) + parts.growth;
    return x < 6.0f ? natural_logarithm(sum) + (rise - (sum - 1.0f)) / sum : far;
  }
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
