// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/bessel.hpp>
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// A direction by its fibre: θ is its inclination from the plane at right angles to the fibre. The azimuth is kept as
/// a vector of that plane, of any length but 0, so that none of its digits is lost to an angle.
template <real_number Real>
struct fibre_direction {
  Real sine;    ///< sin θ, the part along the fibre
  Real cosine;  ///< cos θ, [0, 1]
  Real y, z;    ///< the part across the fibre; (1, 0) stands for a direction along it
};

/// The direction of a unit vector with x along the fibre. Its cosine is √(1 - x²), whatever y and z are.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline fibre_direction<Real> fibre_direction_of(Real x, Real y, Real z) noexcept;
template <std::floating_point Real>
[[nodiscard, gnu::always_inline]] inline fibre_direction<Real> fibre_direction_of(const glm::vec<3, Real>& w) noexcept;

/// Light spread along the fibre by a rough cuticle, normalised over the sphere: a von Mises–Fisher distribution seen
/// by its inclination. Made once per roughness. [d'Eon 2011 §3.1, Eq. 7]
template <real_number Real>
struct longitudinal_lobe {
  Real variance;       ///< v, [1e-8, inf)
  Real concentration;  ///< 1/v
  Real height;         ///< e^(1/v) / (2 v sinh(1/v)), which does not overflow where its factors do
};

/// The lobe of variance v, clamped to at least 1e-8; NaN gives that.
template <real_number Real>
[[nodiscard]] inline longitudinal_lobe<Real> make_longitudinal_lobe(Real variance) noexcept;

/// Two inclinations as M sees them.
template <real_number Real>
struct inclination_pair {
  Real gap;             ///< 1 - cos(θ_i + θ_o), [0, 2], precise where small
  Real cosine_product;  ///< cos θ_i cos θ_o, [0, 1]
};

/// M(θ_i, θ_o) = e^(-sin θ_i sin θ_o / v) I₀(cos θ_i cos θ_o / v) / (2 v sinh(1/v)); its integral over θ_i weighted
/// with cos θ_i is 1 whatever θ_o and v are.
///
/// The exponent is formed as gap/v, where nothing cancels: relative error below 1e-6 · (1 + gap/v) in float
/// where gap ≤ 81 v and M is normal; beyond, 0 or what is left of a denormal exponential.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real evaluate_longitudinal(const longitudinal_lobe<Real>& lobe,
                                                                    inclination_pair<Real> pair) noexcept;

/// M of two inclinations given by sine and cosine.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real evaluate_longitudinal(const longitudinal_lobe<Real>& lobe, Real sin_i,
                                                                    Real cos_i, Real sin_o, Real cos_o) noexcept;

/// Draws θ_i with density M(θ_i, θ_o) cos θ_i from two numbers in [0, 1). Its sine and cosine come from a unit vector,
/// so that the cosine is precise near the fibre's axis too. The outermost 3e-8 of a narrow lobe is drawn in at its
/// edge, beyond which M would be 0. [d'Eon 2013; Jakob 2012]
template <std::floating_point Real>
[[nodiscard]] inline rotation<Real> sample_longitudinal(const longitudinal_lobe<Real>& lobe, Real sin_o, Real cos_o,
                                                        Real u, Real turn) noexcept;

// ---------------------------------------------------------------------------------------------------------

/// The sine of the sum of two inclinations, which keeps its digits where they nearly cancel: precise for exact sines.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real sine_of_sum(Real sin_a, Real cos_a, Real sin_b, Real cos_b) noexcept {
  // sin(a + b) sin(a - b) = sin²a - sin²b: where the terms of the sum cancel, those of sin(a - b) do not.
  const Real first = sin_a * cos_b;
  const Real second = cos_a * sin_b;
  const Real cancels = select(first * second < Real(0), Real(1), Real(0));
  const Real difference = select(cancels > Real(0), first - second, Real(1));
  const Real quotient = (sin_a - sin_b) * (sin_a + sin_b) / difference;
  return select(cancels > Real(0), quotient, first + second);
}

/// 1 - cos x of an angle given by both, precise where x is small.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real versine(rotation<Real> x) noexcept {
  const Real acute = greatest(x.cosine, Real(0));
  return select(x.cosine > Real(0), x.sine * x.sine / (Real(1) + acute), Real(1) - x.cosine);
}

template <real_number Real>
fibre_direction<Real> fibre_direction_of(Real x, Real y, Real z) noexcept {
  const Real length2 = y * y + z * z;
  const Real cosine = square_root(greatest((Real(1) - x) * (Real(1) + x), Real(0)));
  return fibre_direction<Real>{x, cosine, select(length2 > Real(0), y, Real(1)), select(length2 > Real(0), z, Real(0))};
}

template <std::floating_point Real>
fibre_direction<Real> fibre_direction_of(const glm::vec<3, Real>& w) noexcept {
  return fibre_direction_of(w.x, w.y, w.z);
}

template <real_number Real>
longitudinal_lobe<Real> make_longitudinal_lobe(Real variance) noexcept {
  const Real v = greatest(variance, Real(1e-8));
  return longitudinal_lobe<Real>{v, Real(1) / v, Real(1) / (v * one_minus_exponential(Real(2) / v))};
}

template <real_number Real>
Real evaluate_longitudinal(const longitudinal_lobe<Real>& lobe, inclination_pair<Real> pair) noexcept {
  const Real argument = pair.cosine_product * lobe.concentration;
  const bessel_i0_parts<Real> i0 = bessel_i0(argument);
  return exponential((i0.growth - argument) - pair.gap * lobe.concentration) * i0.value * lobe.height;
}

template <real_number Real>
Real evaluate_longitudinal(const longitudinal_lobe<Real>& lobe, Real sin_i, Real cos_i, Real sin_o,
                           Real cos_o) noexcept {
  const rotation<Real> sum = {cos_i * cos_o - sin_i * sin_o, sine_of_sum(sin_i, cos_i, sin_o, cos_o)};
  return evaluate_longitudinal(lobe, inclination_pair<Real>{versine(sum), cos_i * cos_o});
}

template <std::floating_point Real>
rotation<Real> sample_longitudinal(const longitudinal_lobe<Real>& lobe, Real sin_o, Real cos_o, Real u,
                                   Real turn) noexcept {
  // The polar angle about the mirrored direction (-sin, cos) has density ~ e^(cos/v); w = 1 - cos of it.
  const Real opposite = exponential(Real(-2) * lobe.concentration);
  const Real drawn = Real(0) - lobe.variance * natural_logarithm(greatest(u + (Real(1) - u) * opposite, Real(3e-8)));
  const Real w = least(greatest(drawn, Real(0)), Real(2));
  const Real polar_sine = square_root(w * (Real(2) - w));
  const rotation<Real> around = rotation_by(Real(6.283185307179586477) * turn);
  const Real along = polar_sine * around.cosine * cos_o - (Real(1) - w) * sin_o;
  const Real outward = (Real(1) - w) * cos_o + polar_sine * around.cosine * sin_o;
  const Real aside = polar_sine * around.sine;
  const Real scale = Real(1) / square_root(along * along + outward * outward + aside * aside);
  return rotation<Real>{square_root(outward * outward + aside * aside) * scale, along * scale};
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
