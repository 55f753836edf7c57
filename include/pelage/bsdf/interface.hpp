// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

namespace pelage::inline PELAGE_ABI {

/// What a smooth dielectric surface does with unpolarised light. Both parts keep their relative precision: at grazing
/// incidence 1 - reflected has lost what `transmitted` still has, at normal incidence the reverse.
template <real_number Real>
struct interface_shares {
  Real reflected;    ///< F, [0, 1]
  Real transmitted;  ///< 1 - F, [0, 1]
};

/// The shares of a surface met at `cos_theta` in [0, 1], `eta` the index behind over the index before, (0, 1e18): exact
/// Fresnel equations. cos_theta = 0, total reflection and NaN give (1, 0); eta = 1 gives (0, 1) except for cos_theta
/// below 1e-18, which may count as 0. Relative error of each below 1.3e-6 in float for eta in [1, 1000] and cosines
/// from 1e-30 on; for eta in [0.3, 1) the absolute one grows to 8e-3 beside the critical angle.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline interface_shares<Real> dielectric_interface(Real cos_theta, Real eta) noexcept;

/// The same with Bravais indices: light in a plane inclined to a cylinder's section refracts in the section as if
/// by η′, and its second polarisation reflects as if by η″. [Marschner 2003 App. B]
///
/// `cos_outside`, `cos_inside`: cosines of incidence and of refraction by η′ in the section, [0, 1].
/// `cos_outside` = 0 gives (1, 0), NaN (NaN, NaN).
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline interface_shares<Real> bravais_interface(Real cos_outside, Real cos_inside,
                                                                                  Real eta_perpendicular,
                                                                                  Real eta_parallel) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <real_number Real>
interface_shares<Real> dielectric_interface(Real cos_theta, Real eta) noexcept {
  // η² cos²θt = η² - sin²θ, written so that nothing cancels for eta near 1 and grazing light.
  const Real contrast = (eta - Real(1)) * (eta + Real(1));
  const Real inside2 = contrast + cos_theta * cos_theta;
  const Real enters = select(inside2 > Real(0), select(cos_theta > Real(0), Real(1), Real(0)), Real(0));
  const Real inside = square_root(greatest(inside2, Real(0)));
  const Real parallel = eta * eta * cos_theta;
  const Real over_perpendicular = Real(1) / (cos_theta + inside + (Real(1) - enters));
  const Real over_parallel = Real(1) / (parallel + inside + (Real(1) - enters));
  // Both amplitudes (a - b)/(a + b) as (a² - b²)/(a + b)²: the difference of squares is known without cancelling. And
  // 1 - r² = 4ab/(a + b)².
  const Real r_perpendicular = contrast * over_perpendicular * over_perpendicular;
  const Real r_parallel =
      contrast * over_parallel * ((eta * eta + Real(1)) * cos_theta * cos_theta - Real(1)) * over_parallel;
  const Real reflected = Real(0.5) * (r_perpendicular * r_perpendicular + r_parallel * r_parallel);
  const Real through =
      inside * (cos_theta * over_perpendicular * over_perpendicular + parallel * over_parallel * over_parallel);
  return interface_shares<Real>{select(enters > Real(0), least(reflected, Real(1)), Real(1)),
                                select(enters > Real(0), least(Real(2) * through, Real(1)), Real(0))};
}

template <real_number Real>
interface_shares<Real> bravais_interface(Real cos_outside, Real cos_inside, Real eta_perpendicular,
                                         Real eta_parallel) noexcept {
  // r = (a - b)/(a + b) for both polarisations, so 1 - r² = 4ab/(a + b)², which does not cancel.
  const Real perpendicular = eta_perpendicular * cos_inside;
  const Real parallel = eta_parallel * cos_outside;
  const Real sum_perpendicular = cos_outside + perpendicular;
  const Real sum_parallel = parallel + cos_inside;
  const Real lit = select(cos_outside > Real(0), Real(1), Real(0));
  const Real over_perpendicular = lit / (sum_perpendicular + (Real(1) - lit));
  const Real over_parallel = lit / (sum_parallel + (Real(1) - lit));
  const Real r_perpendicular = (cos_outside - perpendicular) * over_perpendicular;
  const Real r_parallel = (parallel - cos_inside) * over_parallel;
  const Real reflected = Real(0.5) * (r_perpendicular * r_perpendicular + r_parallel * r_parallel);
  const Real through = cos_outside * perpendicular * over_perpendicular * over_perpendicular +
                       parallel * cos_inside * over_parallel * over_parallel;
  return interface_shares<Real>{reflected + (Real(1) - lit), Real(2) * through};
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
