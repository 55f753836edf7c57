// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/real_number.hpp>

#include <limits>

namespace pelage::inline PELAGE_ABI {

/// The share of a pixel's disc that a fibre's strip covers, [0, 1]: circle minus the caps on the strip's two sides,
/// over the circle. [Yu12 §4.2]
///
/// `offset`: distance from the disc's centre to the strip's axis; its sign does not matter.
/// `fibre_radius`: half the strip's width, [0, inf]. `disc_radius`: [0, inf), in float below 2¹²⁷. All in one length
/// unit.
///
/// In float within 1e-6 relative of the exact area for any ratio of the three, where the area is normal: the area
/// of a thin strip is integrated over its width instead of subtracting two caps that agree in every digit. In double
/// within 5e-7, the formula's own error. Never falls when the fibre grows, save by that error. A fibre of radius 0, or
/// farther off than the two radii: 0. A disc of radius 0 is a point: 1 inside the strip, 0 outside. NaN, a negative
/// radius or an infinite disc: 0. A share of 0 makes no fragment, which the caller drops. Shares of segments that meet
/// are divided by joint.hpp. O(1), one to three square roots.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real disc_strip_share(Real offset, Real fibre_radius,
                                                               Real disc_radius) noexcept;

/// The share of a disc that the cap of height `h` cuts off, h in disc radii, [0, 2]; beyond, the nearer end.
/// NaN: 0. Relative error of the polynomial below 3e-8 for h in [0, 1].
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real cap_share(Real h) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <real_number Real>
Real cap_share(Real h) noexcept {
  // h^(3/2) times a polynomial: the area's own shape at h = 0, and no singularity nearer than h = 2.
  const Real whole = select(h > Real(0), select(h < Real(2), h, Real(2)), Real(0));
  const Real small = select(whole > Real(1), Real(2) - whole, whole);
  Real p = Real(-0.000177318844);
  p = p * small + Real(0.000137821731);
  p = p * small - Real(0.000604818362);
  p = p * small - Real(0.00148269381);
  p = p * small - Real(0.00805321381);
  p = p * small - Real(0.090030634);
  p = p * small + Real(0.600210866);
  const Real share = small * square_root(small) * p;
  return select(whole > Real(1), Real(1) - share, share);
}

template <real_number Real>
Real disc_strip_share(Real offset, Real fibre_radius, Real disc_radius) noexcept {
  const Real d = select(offset < Real(0), Real(0) - offset, offset);
  const Real wide = select(fibre_radius > disc_radius, fibre_radius, disc_radius);
  const Real thin = select(fibre_radius > disc_radius, disc_radius, fibre_radius);
  // How far the strip's near edge reaches into the disc. Subtracting from the wider one first is exact where the
  // whole sum is small.
  const Real reach = (wide - d) + thin;
  const Real left_over = (disc_radius - d) - fibre_radius;
  const Real rho = fibre_radius / disc_radius;
  const Real edge = (disc_radius - d) / disc_radius;

  Real share = Real(0);
  if (!holds_for_all(edge > Real(4) * rho)) {
    const Real near = cap_share(reach / disc_radius);
    share = select(left_over > Real(0), near - cap_share(left_over / disc_radius), near);
  }
  if (holds_for_any(edge > Real(4) * rho)) {
    // Three Gauss points over the strip's width; at four half widths from the rim their error is below 1e-6.
    const Real middle = square_root(edge * (Real(2) - edge));
    const Real lower = edge - Real(0.7745966692414834) * rho;
    const Real upper = edge + Real(0.7745966692414834) * rho;
    const Real sides = square_root(lower * (Real(2) - lower)) + square_root(upper * (Real(2) - upper));
    const Real strip = rho * (Real(8) * middle + Real(5) * sides) * Real(0.07073553026306459);
    share = select(left_over > Real(0), select(edge > Real(4) * rho, strip, share), share);
  }
  share = select(reach < Real(2) * disc_radius, share, Real(1));
  share = select(reach > Real(0), share, Real(0));
  share = select(fibre_radius > Real(0), share, Real(0));
  share = select(disc_radius < Real(std::numeric_limits<float>::infinity()), share, Real(0));
  return select(disc_radius < Real(0), Real(0), share);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
