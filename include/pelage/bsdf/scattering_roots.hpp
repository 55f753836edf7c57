// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace pelage::inline PELAGE_ABI {

/// The places across a fibre's width from which light leaves at one azimuth: all h with φ(p, h) = φ, where
/// φ(p, h) = 2pγ_t - 2γ_i + pπ, sin γ_i = h, sin γ_t = h/η′. [Marschner 2003 §5.2, Eq. 9]
///
/// R has always one; TT has one in closed form or none; TRT has none, one or three, two where η′ < √2. TRT's are found
/// between the caustics, where φ is monotone: the paper's cubic or a parabola at the caustic as a start, Newton's
/// steps from there, bisection where one leaves its bracket. Everything is an offset from the nearer end of the
/// bracket, so that neither a root by the caustic nor one by the fibre's edge loses its digits.
template <std::floating_point Real>
struct scattering_root {
  Real sine;    ///< sin γ_i = h, [-1, 1]
  Real cosine;  ///< cos γ_i, [0, 1]
  Real slope;   ///< dφ/dγ_i / 2 = p cos γ_i/(η′ cos γ_t) - 1; dφ/dh is 2 slope/cos γ_i
};

/// Up to three roots, the first `count` of them valid.
template <std::floating_point Real>
struct scattering_roots {
  std::array<scattering_root<Real>, 3> root;
  std::uint32_t count;  ///< [0, 3]
};

/// The caustic of TRT: where two of its roots meet, at ±φ. [Marschner 2003 App. B]
template <std::floating_point Real>
struct caustic_point {
  Real sine;          ///< h_c = √((4 - η′²)/3), 0 where η′ ≥ 2 and there is no caustic
  Real cosine;        ///< √(1 - h_c²)
  Real half_azimuth;  ///< φ(2, h_c)/2 - π, [0, π/2]; φ_c is twice it
  Real curvature;     ///< -d²(φ/2)/dγ_i² there, (0, inf); 0 where there is none
};

/// The roots of path p: 0 is R, 1 TT, 2 TRT. `phi`: azimuth in radians, any; `excess`: η′² - 1 = (η² - 1)/cos²θ_d,
/// (0, inf), which keeps digits that η′ has lost. Symmetric: -φ negates every h. NaN gives no roots.
///
/// Absolute error of h in float for |dφ/dh| ≥ 0.2 and an excess in [1e-4, 1000]: below 2.5e-7 for R and TT, 7e-7 where
/// φ is beyond ±π and wrapped, up to ±1000; for TRT below 1e-6 max(1, 0.6/√excess)/min(1, |dφ/dh|). In double 2e-15
/// stands in the place of 1e-6. R's h = 1 and -1 are one azimuth, ±π: within rounding of it either may come.
template <std::floating_point Real>
[[nodiscard]] scattering_roots<Real> find_scattering_roots(int path, Real phi, Real excess) noexcept;

/// The caustic of an index by η′² - 1, as above.
template <std::floating_point Real>
[[nodiscard]] caustic_point<Real> find_caustic(Real excess) noexcept;

/// dφ/dh of a path at an offset h in (-1, 1).
template <std::floating_point Real>
[[nodiscard]] Real azimuth_derivative(int path, Real h, Real eta_perpendicular) noexcept;

/// The angle x + 2πk in [-π, π].
template <std::floating_point Real>
[[nodiscard]] Real wrapped_angle(Real x) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
Real wrapped_angle(Real x) noexcept {
  const Real turns = std::floor(x * Real(0.159154943091895336) + Real(0.5));
  // 2π in two parts, the first of few digits; the second is what it lacks.
  return (x - turns * Real(6.28125)) - turns * Real(0.00193530717958647693);
}

template <std::floating_point Real>
Real azimuth_derivative(int path, Real h, Real eta_perpendicular) noexcept {
  const Real outside = square_root((Real(1) - h) * (Real(1) + h));
  const Real inside = square_root((eta_perpendicular - h) * (eta_perpendicular + h));
  return Real(2) * (Real(path) / inside - Real(1) / outside);
}

template <std::floating_point Real>
caustic_point<Real> find_caustic(Real excess) noexcept {
  const Real sine2 = (Real(3) - excess) / Real(3);
  if (!(sine2 > Real(0)) || !(excess > Real(0))) {
    return caustic_point<Real>{Real(0), Real(1), Real(0), Real(0)};
  }
  const Real sine = square_root(sine2);
  const Real cosine = square_root(excess / Real(3));
  // There η′ cos γ_t = 2 cos γ_i, which leaves η′² sin(2γ_t - γ_i) = sin³γ_i and the like for the cosine.
  const Real sin_half = sine * sine * sine;
  const Real cos_half = cosine * (Real(4) * cosine * cosine + Real(3) * sine * sine);
  const Real curvature = Real(0.25) * sine * excess / (cosine * cosine * cosine);
  return caustic_point<Real>{sine, cosine, unsigned_angle(sin_half, cos_half), curvature};
}

namespace detail {

/// One monotone stretch of 2γ_t - γ_i on [0, π/2], measured from one of its ends.
template <std::floating_point Real>
struct root_bracket {
  Real eta;
  Real excess;             ///< η′² - 1
  rotation<Real> outside;  ///< γ_i at the reference end
  Real direction;          ///< 1 if γ_i grows from there, -1 if it falls
  Real rise;               ///< the sought value of 2γ_t - γ_i less that at the reference
};

/// What the stretch does at an offset x from its reference end: 2γ_t - γ_i less the sought value, and `root` there. Not
/// both in one struct: glslang 12 follows `precise` round the loop below through a struct's parts without end.
template <std::floating_point Real>
[[nodiscard]] Real sample_bracket(const root_bracket<Real>& bracket, Real x, const caustic_point<Real>& caustic,
                                  scattering_root<Real>& root) noexcept {
  const Real eta = bracket.eta;
  const rotation<Real> halfway = rotation_by(Real(0.5) * bracket.direction * x);
  const rotation<Real> middle = turned_by(bracket.outside, halfway);
  const rotation<Real> outside = turned_by(middle, halfway);
  // sin a - sin b = 2 cos((a + b)/2) sin((a - b)/2) keeps the digits of a small offset.
  const Real gain = Real(2) * middle.cosine * halfway.sine;
  const Real sum = outside.sine + bracket.outside.sine;
  const Real inside = square_root((eta - outside.sine) * (eta + outside.sine));
  const Real inside_there = square_root((eta - bracket.outside.sine) * (eta + bracket.outside.sine));
  const Real sine_sum = outside.sine * inside_there + bracket.outside.sine * inside;
  const Real turned = sine_sum > Real(0) ? gain * sum / sine_sum : Real(0);
  const Real from_caustic = bracket.outside.sine == caustic.sine
                                ? Real(0) - gain * sum
                                : (caustic.sine - outside.sine) * (caustic.sine + outside.sine);
  const Real above = caustic.curvature > Real(0) ? Real(0) : (Real(3) - bracket.excess) / Real(3);
  const Real cosine = absolute(outside.cosine);
  const Real slope = Real(3) * (from_caustic + above) / ((Real(2) * cosine + inside) * inside);
  root = scattering_root<Real>{outside.sine, cosine, slope};
  return (Real(2) * angle_of_sine(turned) - bracket.direction * x) - bracket.rise;
}

/// The paper's cubic: the root of γ³ - (a/b)γ + ψ/b = 0 with asin(sin γ/η′) taken as (3c/π)γ - (4c/π³)γ³, c =
/// asin(1/η′). `turn` 0 gives the greatest of three roots, 1 the middle one. Negative if it has not three.
/// [Marschner 2003 Eq. 10]
template <std::floating_point Real>
[[nodiscard]] Real cubic_root_start(Real eta, Real half_azimuth, int turn) noexcept {
  const Real c = angle_of_sine(Real(1) / eta);
  const Real a = Real(1.90985931710274403) * c - Real(1);
  const Real b = Real(0.258012275465595961) * c;
  if (!(a > Real(0))) {
    return Real(-1);
  }
  const Real scale = Real(2) * square_root(a / (Real(3) * b));
  const Real x = Real(-4) * half_azimuth / (b * scale * scale * scale);
  if (!(absolute(x) < Real(1))) {
    return Real(-1);
  }
  const Real third = unsigned_angle(square_root((Real(1) - x) * (Real(1) + x)), x) / Real(3);
  return scale * rotation_by(third - Real(turn) * Real(2.09439510239319549)).cosine;
}

/// 2γ_t - γ_i at the fibre's edge, 2 asin(1/η′) - π/2, whose sine is 2/η′² - 1.
template <std::floating_point Real>
[[nodiscard]] Real edge_half_azimuth(Real excess) noexcept {
  return angle_of(Real(1) - excess, Real(2) * square_root(excess));
}

/// The root of one stretch: 2γ_t - γ_i = ψ between the caustic and 0 (`inner`) or the fibre's edge.
template <std::floating_point Real>
[[nodiscard]] scattering_root<Real> solve_stretch(Real excess, Real half_azimuth, bool inner,
                                                  const caustic_point<Real>& caustic) noexcept {
  const Real right_angle = Real(1.57079632679489662);
  const Real eta = square_root(Real(1) + excess);
  const Real caustic_angle = angle_of(caustic.sine, caustic.cosine);
  const Real extent = inner ? caustic_angle : right_angle - caustic_angle;
  const Real drop = caustic.half_azimuth - half_azimuth;
  const Real parabola =
      caustic.curvature > Real(0) ? square_root(Real(2) * greatest(drop, Real(0)) / caustic.curvature) : extent;
  const Real cubic = cubic_root_start(eta, half_azimuth, inner ? 1 : 0);
  const bool by_caustic = parabola < Real(0.5) * extent;

  root_bracket<Real> bracket;
  bracket.eta = eta;
  bracket.excess = excess;
  Real x = parabola;
  if (by_caustic) {
    bracket.outside = rotation<Real>{caustic.cosine, caustic.sine};
    bracket.direction = inner ? Real(-1) : Real(1);
    bracket.rise = Real(0) - drop;
  } else if (inner) {
    bracket.outside = rotation<Real>{Real(1), Real(0)};
    bracket.direction = Real(1);
    bracket.rise = half_azimuth;
    x = cubic;
  } else {
    bracket.outside = rotation<Real>{Real(0), Real(1)};
    bracket.direction = Real(-1);
    bracket.rise = half_azimuth - edge_half_azimuth(excess);
    x = right_angle - cubic;
  }
  if (!(x >= Real(0) && x <= extent)) {
    x = Real(0.5) * extent;
  }

  // The stretch rises away from its reference except from the caustic, where it falls.
  const Real towards = by_caustic ? Real(-1) : Real(1);
  Real low = Real(0);
  Real high = extent;
  scattering_root<Real> root = scattering_root<Real>{Real(0), Real(1), Real(1)};
  Real above = sample_bracket(bracket, x, caustic, root);
  for (int iteration = 0; iteration < 60; ++iteration) {
    const bool past = towards * above > Real(0);
    low = past ? low : x;
    high = past ? x : high;
    const Real newton = x - above / (bracket.direction * root.slope);
    const bool inside = newton > low && newton < high;
    const Real next = inside ? newton : Real(0.5) * (low + high);
    const Real moved = absolute(next - x);
    x = next;
    above = sample_bracket(bracket, x, caustic, root);
    if (moved <= std::numeric_limits<Real>::epsilon() * x) {
      break;
    }
  }
  return root;
}

}  // namespace detail

template <std::floating_point Real>
scattering_roots<Real> find_scattering_roots(int path, Real phi, Real excess) noexcept {
  scattering_roots<Real> roots;
  for (std::uint32_t k = 0u; k < 3u; ++k) {
    roots.root[k] = scattering_root<Real>{Real(0), Real(1), Real(1)};
  }
  roots.count = 0u;
  const Real above_one = greatest(excess, Real(1e-12));
  const Real eta = square_root(Real(1) + above_one);
  const Real azimuth = wrapped_angle(phi);
  const Real side = azimuth < Real(0) ? Real(-1) : Real(1);
  const Real half_azimuth = Real(0.5) * absolute(azimuth);
  if (path == 0) {
    const rotation<Real> mirror = rotation_by(half_azimuth);
    roots.root[0] = scattering_root<Real>{Real(0) - side * mirror.sine, absolute(mirror.cosine), Real(-1)};
    roots.count = half_azimuth == half_azimuth ? 1u : 0u;
  }
  if (path == 1) {
    // δ = γ_i - γ_t = (π - φ)/2 and Snell's law give tan γ_i = η′ sin δ/(η′ cos δ - 1).
    const rotation<Real> mirror = rotation_by(half_azimuth);
    const Real cosine_bend = mirror.sine;
    const Real sine_bend = mirror.cosine;
    const Real along = (above_one * cosine_bend * cosine_bend - sine_bend * sine_bend) / (eta * cosine_bend + Real(1));
    const Real aside = eta * sine_bend;
    const Real hypotenuse = square_root(along * along + aside * aside);
    if (along >= Real(0) && hypotenuse > Real(0)) {
      const Real sine = aside / hypotenuse;
      const Real cosine = along / hypotenuse;
      const Real inside = square_root((eta - sine) * (eta + sine));
      const Real slope = Real(0) - above_one / ((cosine + inside) * inside);
      roots.root[0] = scattering_root<Real>{side * sine, cosine, slope};
      roots.count = 1u;
    }
  }
  if (path == 2) {
    const caustic_point<Real> caustic = find_caustic(above_one);
    const Real edge = detail::edge_half_azimuth(above_one);
    if (caustic.curvature > Real(0) && half_azimuth <= caustic.half_azimuth) {
      const scattering_root<Real> near = detail::solve_stretch(above_one, half_azimuth, true, caustic);
      roots.root[roots.count] = scattering_root<Real>{side * near.sine, near.cosine, near.slope};
      roots.count = roots.count + 1u;
      if (half_azimuth >= edge) {
        const scattering_root<Real> far = detail::solve_stretch(above_one, half_azimuth, false, caustic);
        roots.root[roots.count] = scattering_root<Real>{side * far.sine, far.cosine, far.slope};
        roots.count = roots.count + 1u;
      }
    }
    if (Real(0) - half_azimuth >= edge) {
      const scattering_root<Real> opposite = detail::solve_stretch(above_one, Real(0) - half_azimuth, false, caustic);
      roots.root[roots.count] = scattering_root<Real>{Real(0) - side * opposite.sine, opposite.cosine, opposite.slope};
      roots.count = roots.count + 1u;
    }
  }
  return roots;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
