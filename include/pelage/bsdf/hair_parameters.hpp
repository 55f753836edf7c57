// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

#include <array>
#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// Pigment in a fibre, as concentrations that multiply the absorption of human hair per radius; both [0, inf).
/// Eumelanin browns (0.1 light blond, 0.3 dark blond, 1.3 dark brown, 8 black), pheomelanin reddens.
template <real_number Real>
struct melanin {
  Real eumelanin;
  Real pheomelanin;
};

/// Hair colours to start from.
enum class hair_colour { blond, red, brown, black };

/// The pigment of a colour: a mass of blond hair has an albedo of about 0.28, 0.19, 0.09, of red 0.09, 0.03, 0.004,
/// of brown 0.05, 0.02, 0.004 and of black none, so that it shows its highlight only.
template <std::floating_point Real>
[[nodiscard]] melanin<Real> melanin_of(hair_colour colour) noexcept;

/// σ_a for red, green, blue per fibre radius, linear in both concentrations. [d'Eon 2011 §6.1; constants of Chiang
/// 2016]
template <real_number Real>
[[nodiscard]] std::array<Real, 3> absorption_of(melanin<Real> pigment) noexcept {
  return std::array<Real, 3>{Real(0.419) * pigment.eumelanin + Real(0.187) * pigment.pheomelanin,
                             Real(0.697) * pigment.eumelanin + Real(0.4) * pigment.pheomelanin,
                             Real(1.37) * pigment.eumelanin + Real(1.05) * pigment.pheomelanin};
}

/// The pigment from an artist's controls. `amount` in [0, 1] is how much light it takes, evenly to the eye: 0 clear,
/// 0.8 dark brown, 1 the black of concentration 40 (the concentration is -ln(max(1 - amount, e⁻⁴⁰))). `redness`
/// in [0, 1] is the share of pheomelanin.
template <std::floating_point Real>
[[nodiscard]] melanin<Real> melanin_from_controls(Real amount, Real redness) noexcept;

/// The fit's exponent: √σ_a = -ln(colour) / fit.
template <std::floating_point Real>
[[nodiscard]] Real albedo_fit(Real beta_n) noexcept {
  const Real b = saturate(beta_n);
  return ((((Real(0.245) * b + Real(5.574)) * b - Real(10.73)) * b + Real(2.532)) * b - Real(0.215)) * b + Real(5.969);
}

/// σ_a of the fibre whose *mass* of hair has the albedo `colour`, [1e-4, 1], held there, by the fit to multiple
/// scattering in a head of hair of azimuthal roughness β_n in [0, 1]. One fibre alone is brighter. [Chiang 2016 §4.2]
template <std::floating_point Real>
[[nodiscard]] Real absorption_from_albedo(Real colour, Real beta_n) noexcept;

/// The albedo of a mass of such fibres: the inverse of absorption_from_albedo.
template <std::floating_point Real>
[[nodiscard]] Real albedo_from_absorption(Real sigma_a, Real beta_n) noexcept {
  return exponential(Real(0) - safe_sqrt(sigma_a) * albedo_fit(beta_n));
}

/// The variance of M for a longitudinal roughness β_m that looks even to the eye, [0, 1]: [Chiang 2016 §4.1]
/// (0.726 β + 0.812 β² + 3.7 β²⁰)². The R lobe's; TT has a quarter of it, TRT and the residual four times.
/// The constants are the float nearest to the printed ones in every type, so that float and double mean one fibre.
template <real_number Real>
[[nodiscard]] Real longitudinal_variance(Real beta_m) noexcept;

/// The scale of N in radians for an azimuthal roughness β_n that looks even to the eye, [0, 1]: [Chiang 2016 §4.1]
/// √(π/8) (0.265 β + 1.194 β² + 5.372 β²²), constants as above.
template <real_number Real>
[[nodiscard]] Real azimuthal_scale(Real beta_n) noexcept;

/// The roughness β_m whose lobe has the standard deviation `width` in radians, (0, 5.238]: the inverse of
/// longitudinal_variance, for widths measured as in Marschner's model, within 3e-7 in float and 1e-11 in double.
/// Outside the range: the nearer end's roughness.
template <std::floating_point Real>
[[nodiscard]] Real roughness_of_width(Real width) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
melanin<Real> melanin_of(hair_colour colour) noexcept {
  if (colour == hair_colour::blond) {
    return melanin<Real>{Real(0.1), Real(0.03)};
  }
  if (colour == hair_colour::red) {
    return melanin<Real>{Real(0.05), Real(0.8)};
  }
  if (colour == hair_colour::brown) {
    return melanin<Real>{Real(0.6), Real(0.06)};
  }
  return melanin<Real>{Real(8), Real(0)};
}

template <std::floating_point Real>
melanin<Real> melanin_from_controls(Real amount, Real redness) noexcept {
  const Real left = greatest(Real(1) - saturate(amount), Real(4.248354255e-18));
  const Real concentration = Real(0) - natural_logarithm(left);
  return melanin<Real>{concentration * (Real(1) - saturate(redness)), concentration * saturate(redness)};
}

template <std::floating_point Real>
Real absorption_from_albedo(Real colour, Real beta_n) noexcept {
  const Real held = least(greatest(colour, Real(1e-4)), Real(1));
  return sqr(natural_logarithm(held) / albedo_fit(beta_n));
}

template <real_number Real>
Real longitudinal_variance(Real beta_m) noexcept {
  const Real b2 = beta_m * beta_m;
  const Real b4 = b2 * b2;
  const Real b8 = b4 * b4;
  const Real width = Real(0.726f) * beta_m + Real(0.812f) * b2 + Real(3.7f) * (b8 * b8 * b4);
  return width * width;
}

template <real_number Real>
Real azimuthal_scale(Real beta_n) noexcept {
  const Real b2 = beta_n * beta_n;
  const Real b4 = b2 * b2;
  const Real b8 = b4 * b4;
  const Real fit = Real(0.265f) * beta_n + Real(1.194f) * b2 + Real(5.372f) * (b8 * b8 * b4 * b2);
  return Real(0.626657069f) * fit;
}

template <std::floating_point Real>
Real roughness_of_width(Real width) noexcept {
  Real low = Real(0);
  Real high = Real(1);
  for (int halving = 0; halving < 40; ++halving) {
    const Real middle = Real(0.5) * (low + high);
    const bool narrow = longitudinal_variance(middle) < width * width;
    low = narrow ? middle : low;
    high = narrow ? high : middle;
  }
  return Real(0.5) * (low + high);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
