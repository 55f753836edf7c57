// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang.hpp>
#include <pelage/core/exact_begin.hpp>

#include <array>
#include <concepts>

namespace pelage::inline PELAGE_ABI {

// Chiang's model in the parameters of pbrt-v4, MaterialX and Cycles, for materials that were made there. All three have
// x along the curve from root to tip, as fibre_direction has; what differs is the sign of the tilt and who remaps what.
// Defaults are those of the renderer, not set here: give every member.

/// HairBxDF of pbrt-v4. Its σ_a is per fibre radius, from pigment absorption_of(), from a colour
/// absorption_from_albedo().
template <real_number Real>
struct pbrt_hair {
  Real eta;                     ///< [1, inf), 1.55 by default
  std::array<Real, 3> sigma_a;  ///< [0, inf]
  Real beta_m;                  ///< [0, 1], 0.3 by default
  Real beta_n;                  ///< [0, 1], 0.3 by default
  Real alpha;                   ///< degrees, 2 by default: R turns towards +x, away from where hair's scales send it
};

/// The same fibre: the tilt is α in radians, of the same sign.
template <real_number Real>
[[nodiscard]] inline chiang_parameters<Real> chiang_from_pbrt(const pbrt_hair<Real>& hair) noexcept;
template <real_number Real>
[[nodiscard]] inline pbrt_hair<Real> pbrt_from_chiang(const chiang_parameters<Real>& fibre) noexcept;

/// The vector2 that chiang_hair_bsdf of MaterialX calls a lobe's roughness.
template <real_number Real>
struct materialx_lobe {
  Real variance;  ///< x: of M, [0.001, 1], clamped to that
  Real scale;     ///< y: of N without the factor √(π/8), [0.001, 1], clamped to that
};

/// chiang_hair_bsdf of MaterialX. Its tints are colours; here grey, since a fibre's are: multiply chiang_view's
/// attenuation by a colour, that of TRT in the residual lobe as well.
template <real_number Real>
struct materialx_hair {
  std::array<Real, 3> tints;                   ///< of R, TT and TRT, [0, inf)
  Real ior;                                    ///< [1, inf), 1.55 by default
  std::array<materialx_lobe<Real>, 3> lobes;   ///< R, TT and TRT; N is taken from R, whose scale is all lobes' there
  Real cuticle_angle;                          ///< [0, 1]: ½ is no tilt; 0.4889 turns R towards +x by 2 · 2°
  std::array<Real, 3> absorption_coefficient;  ///< σ_a, [0, inf]
};

/// chiang_hair_roughness: the roughnesses of R, TT and TRT. `longitudinal`, `azimuthal`: [0.001, 1], clamped to that;
/// 0.1 and 0.2 by default. `scale_tt`, `scale_trt`: of the lobes' widths, 0.5 and 2 by default, Chiang's own.
template <real_number Real>
[[nodiscard]] inline std::array<materialx_lobe<Real>, 3> materialx_roughness(Real longitudinal, Real azimuthal,
                                                                             Real scale_tt, Real scale_trt) noexcept;

/// deon_hair_absorption_from_melanin in its default colours, which are e⁻ᶜ of absorption_of()'s constants.
/// `concentration`: [0, 1], from 0.9999 on as there; 0.25 by default. `redness`: [0, 1], 0.5 by default.
template <std::floating_point Real>
[[nodiscard]] std::array<Real, 3> materialx_absorption_from_melanin(Real concentration, Real redness) noexcept;

/// chiang_hair_absorption_from_color for one channel: absorption_from_albedo() with colours from 0.001 on.
/// `azimuthal`: [0, 1], 0.2 by default.
template <std::floating_point Real>
[[nodiscard]] Real materialx_absorption_from_colour(Real colour, Real azimuthal) noexcept;

/// The same fibre, whose tilt is -(cuticle_angle - ½)π: MaterialX turns the light where Chiang turns the eye. Without a
/// tilt all values are the same; with one the lobes lie at the same angles, and their heights differ with the cosines
/// of the inclinations: by at most 15 % for 2° and inclinations up to 45°.
template <real_number Real>
[[nodiscard]] inline chiang_fibre<Real> chiang_from_materialx(const materialx_hair<Real>& hair) noexcept;

/// The nearest that chiang_hair_bsdf has to parameters whose roughnesses it clamps.
template <real_number Real>
[[nodiscard]] inline materialx_hair<Real> materialx_from_chiang(const chiang_parameters<Real>& fibre) noexcept;

/// Principled hair of Cycles by Chiang's model, at one strand; a melanin material has its `absorption` from
/// cycles_absorption_from_melanin().
template <real_number Real>
struct cycles_hair {
  std::array<Real, 3> absorption;  ///< σ_a, [0, inf]: direct, or by the functions below
  Real roughness;                  ///< [0.001, 1], clamped to that, 0.3 by default
  Real radial_roughness;           ///< the same
  Real coat;                       ///< [0, 1], clamped to that: how much smoother R is, 0 by default
  Real ior;                        ///< [1, inf), 1.55 by default
  Real offset;                     ///< radians, 2° by default: R turns towards the root
  Real random;                     ///< the strand's own number, [0, 1]; ½ changes nothing
  Real random_roughness;           ///< [0, 1], 0 by default: both roughnesses times 1 + 2 (random - ½) of it
};

/// Roughness after randomising, before it is clamped; of the radial one the absorptions below are made.
template <real_number Real>
[[nodiscard]] inline Real cycles_roughness(Real roughness, Real random, Real random_roughness) noexcept {
  return roughness * (Real(1) + Real(2) * (random - Real(0.5)) * random_roughness);
}

/// σ_a for red, green, blue from Cycles' melanin, `amount` [0, 1], redness [0, 1] and how much the amount varies with
/// the strand's number, `random_colour` [0, 1], clamped to that. Cycles has constants of its own: (0.506, 0.841, 1.653)
/// for eumelanin and (0.343, 0.733, 1.924) for pheomelanin. A tint adds cycles_absorption_from_colour() of it.
template <std::floating_point Real>
[[nodiscard]] std::array<Real, 3> cycles_absorption_from_melanin(Real amount, Real redness, Real random,
                                                                 Real random_colour) noexcept;

/// σ_a of a channel from a reflectance: absorption_from_albedo(), which holds colours below 1e-4 there, where Cycles
/// goes on to infinity.
template <std::floating_point Real>
[[nodiscard]] Real cycles_absorption_from_colour(Real colour, Real radial_roughness) noexcept {
  return absorption_from_albedo(colour, radial_roughness);
}

/// The same fibre: the tilt is -offset.
template <real_number Real>
[[nodiscard]] inline chiang_fibre<Real> chiang_from_cycles(const cycles_hair<Real>& hair) noexcept;

/// The fibre by direct absorption, without coat and randomness.
template <real_number Real>
[[nodiscard]] inline cycles_hair<Real> cycles_from_chiang(const chiang_parameters<Real>& fibre) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// Both MaterialX and Cycles have this range for what their lobes are made of.
template <real_number Real>
[[nodiscard]] inline Real held_roughness(Real x) noexcept {
  return least(greatest(x, Real(0.001)), Real(1));
}

}  // namespace detail

template <real_number Real>
chiang_parameters<Real> chiang_from_pbrt(const pbrt_hair<Real>& hair) noexcept {
  return chiang_parameters<Real>{hair.eta, hair.sigma_a, hair.beta_m, hair.beta_n,
                                 hair.alpha * Real(0.0174532925199432958)};
}

template <real_number Real>
pbrt_hair<Real> pbrt_from_chiang(const chiang_parameters<Real>& fibre) noexcept {
  return pbrt_hair<Real>{fibre.eta, fibre.sigma_a, fibre.beta_m, fibre.beta_n, fibre.tilt * Real(57.2957795130823209)};
}

template <real_number Real>
std::array<materialx_lobe<Real>, 3> materialx_roughness(Real longitudinal, Real azimuthal, Real scale_tt,
                                                        Real scale_trt) noexcept {
  const Real v = longitudinal_variance(detail::held_roughness(longitudinal));
  const Real s = azimuthal_scale(detail::held_roughness(azimuthal)) * Real(1.59576912160573071);
  return std::array<materialx_lobe<Real>, 3>{materialx_lobe<Real>{v, s},
                                             materialx_lobe<Real>{v * scale_tt * scale_tt, s},
                                             materialx_lobe<Real>{v * scale_trt * scale_trt, s}};
}

template <std::floating_point Real>
std::array<Real, 3> materialx_absorption_from_melanin(Real concentration, Real redness) noexcept {
  const Real amount = Real(0) - natural_logarithm(greatest(Real(1) - concentration, Real(0.0001)));
  return absorption_of(melanin<Real>{amount * (Real(1) - redness), amount * redness});
}

template <std::floating_point Real>
Real materialx_absorption_from_colour(Real colour, Real azimuthal) noexcept {
  return absorption_from_albedo(greatest(colour, Real(0.001)), azimuthal);
}

template <real_number Real>
chiang_fibre<Real> chiang_from_materialx(const materialx_hair<Real>& hair) noexcept {
  const Real tilt = (Real(0.5) - hair.cuticle_angle) * Real(3.141592653589793238);
  chiang_fibre<Real> fibre =
      make_chiang_fibre(chiang_parameters<Real>{hair.ior, hair.absorption_coefficient, Real(0.3), Real(0.3), tilt});
  for (std::uint32_t p = 0u; p < 3u; ++p) {
    fibre.tints[p] = hair.tints[p];
    fibre.longitudinal[p] = make_longitudinal_lobe(detail::held_roughness(hair.lobes[p].variance));
  }
  fibre.tints[3] = hair.tints[2];
  fibre.longitudinal[3] = fibre.longitudinal[2];
  fibre.azimuthal = make_azimuthal_lobe(detail::held_roughness(hair.lobes[0].scale) * Real(0.626657068657750126));
  return fibre;
}

template <real_number Real>
materialx_hair<Real> materialx_from_chiang(const chiang_parameters<Real>& fibre) noexcept {
  return materialx_hair<Real>{std::array<Real, 3>{Real(1), Real(1), Real(1)}, fibre.eta,
                              materialx_roughness(fibre.beta_m, fibre.beta_n, Real(0.5), Real(2)),
                              Real(0.5) - fibre.tilt * Real(0.318309886183790672), fibre.sigma_a};
}

template <std::floating_point Real>
std::array<Real, 3> cycles_absorption_from_melanin(Real amount, Real redness, Real random,
                                                   Real random_colour) noexcept {
  const Real varied = amount * (Real(1) + Real(2) * (random - Real(0.5)) * saturate(random_colour));
  const Real concentration = Real(0) - natural_logarithm(greatest(Real(1) - varied, Real(0.0001)));
  const Real eumelanin = concentration * (Real(1) - redness);
  const Real pheomelanin = concentration * redness;
  return std::array<Real, 3>{Real(0.506) * eumelanin + Real(0.343) * pheomelanin,
                             Real(0.841) * eumelanin + Real(0.733) * pheomelanin,
                             Real(1.653) * eumelanin + Real(1.924) * pheomelanin};
}

template <real_number Real>
chiang_fibre<Real> chiang_from_cycles(const cycles_hair<Real>& hair) noexcept {
  const Real along = detail::held_roughness(cycles_roughness(hair.roughness, hair.random, hair.random_roughness));
  const Real around =
      detail::held_roughness(cycles_roughness(hair.radial_roughness, hair.random, hair.random_roughness));
  chiang_fibre<Real> fibre =
      make_chiang_fibre(chiang_parameters<Real>{hair.ior, hair.absorption, along, around, Real(0) - hair.offset});
  const Real first = detail::held_roughness(along * (Real(1) - saturate(hair.coat)));
  fibre.longitudinal[0] = make_longitudinal_lobe(longitudinal_variance(first));
  return fibre;
}

template <real_number Real>
cycles_hair<Real> cycles_from_chiang(const chiang_parameters<Real>& fibre) noexcept {
  return cycles_hair<Real>{fibre.sigma_a, fibre.beta_m,         fibre.beta_n, Real(0),
                           fibre.eta,     Real(0) - fibre.tilt, Real(0.5),    Real(0)};
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
