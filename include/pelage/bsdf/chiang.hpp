// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/azimuthal.hpp>
#include <pelage/bsdf/hair_parameters.hpp>
#include <pelage/bsdf/interface.hpp>
#include <pelage/bsdf/longitudinal.hpp>
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// Hair seen from near by: light that meets a fibre at one offset from its axis is reflected (R), passes (TT), comes
/// back after one inner reflection (TRT) or after more (the residual lobe). [Chiang 2016; Marschner 2003; d'Eon 2011]
///
/// Keeps all four lobes' energy: with nothing absorbed all light leaves. Not reciprocal (the eye's θ and h choose the
/// attenuation), except for the R lobe of an untilted fibre at normal inclination. No allocation, no tables; a fibre is
/// made once per material, a view once per hit, and each light costs the rest.
///
/// Frame: x along the fibre towards its tip, y and z across, right-handed; unit vectors that point away from the fibre.
/// `h` is where the eye's ray meets the fibre across its width, clamped to [-1, 1]: sin γ_o. It is positive on the side
/// of eye × x: seen from +z, on the side of +y.
template <real_number Real>
struct chiang_parameters {
  Real eta;                     ///< index of refraction, [1, inf); hair 1.55
  std::array<Real, 3> sigma_a;  ///< absorption per fibre radius, [0, inf]
  Real beta_m;                  ///< roughness along, [0, 1]; 0 is a very narrow lobe, not a mirror
  Real beta_n;                  ///< roughness round, [0, 1]; 0 is a very narrow lobe, too
  Real tilt;                    ///< α in radians, turns R towards +x; hair, whose scales rise to the tip: -0.035 (2°)
};

/// A fibre ready for use: parameters in the form that the lobes want. `tints` and `variances` may be changed after
/// making it: tints above 1 create light; variances are per lobe R, TT, TRT and residual.
template <real_number Real>
struct chiang_fibre {
  Real eta;
  std::array<Real, 3> sigma_a;
  std::array<Real, 4> tints;                            ///< R, TT, TRT, residual: what multiplies each, 1 by default
  std::array<longitudinal_lobe<Real>, 4> longitudinal;  ///< M of each lobe
  azimuthal_lobe<Real> azimuthal;                       ///< N of R, TT and TRT; the residual's is uniform
  std::array<rotation<Real>, 3> tilts;                  ///< by which θ_o is turned for R, TT, TRT: -2α, α, 4α
};

/// A fibre as one eye sees it at one point of its width.
template <real_number Real>
struct chiang_view {
  fibre_direction<Real> eye;
  std::array<rotation<Real>, 3> tilted;            ///< cos, sin of the tilted θ_o, the cosine by absolute value
  std::array<Real, 3> flipped;                     ///< 1 where that took the sign from the cosine, else 0
  std::array<rotation<Real>, 3> towards;           ///< the middle of each lobe round the fibre, any length
  std::array<std::array<Real, 3>, 4> attenuation;  ///< A_p for red, green, blue; R, TT, TRT, residual
  std::array<Real, 4> weights;  ///< probabilities of the lobes: means of A_p over their sum; all 0 if that is
};

/// Light scattered from one direction to the eye.
template <real_number Real>
struct chiang_result {
  glm::vec<3, Real> value;  ///< f |cos|, to be multiplied by the light and by no further cosine
  Real density;             ///< of sampling that direction, per steradian
};

/// Makes a fibre. Infinite σ_a counts as 1e30.
template <real_number Real>
[[nodiscard]] inline chiang_fibre<Real> make_chiang_fibre(const chiang_parameters<Real>& parameters) noexcept;

/// Makes a view of it.
template <real_number Real>
[[nodiscard]] inline chiang_view<Real> view_chiang(const chiang_fibre<Real>& fibre, Real h,
                                                   const fibre_direction<Real>& eye) noexcept;

/// The whole model at one pair of directions. Finite for every unit vector, grazing ones and those along the fibre
/// included. Where a value exceeds 1e-6, float stays within 5e-5 of double for η in [1.4, 1.8] and β_m, β_n from 0.08
/// on, within 2.5e-4 for η in [1.1, 3] and roughnesses from 0.05 on; 98 values in 100 are within 3e-6.
template <real_number Real>
[[nodiscard]] inline chiang_result<Real> evaluate_chiang(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                                                         const fibre_direction<Real>& light) noexcept;

/// M_p N_p of the four lobes for one light, without attenuations: what evaluation and density share.
template <real_number Real>
[[nodiscard]] inline std::array<Real, 4> chiang_lobes(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                                                      const fibre_direction<Real>& light) noexcept;

/// M_p of the four lobes for one light.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline std::array<Real, 4> chiang_inclinations(
    const chiang_fibre<Real>& fibre, const chiang_view<Real>& view, const fibre_direction<Real>& light) noexcept;

/// The density alone, per steradian.
template <real_number Real>
[[nodiscard]] inline Real chiang_density(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                                         const fibre_direction<Real>& light) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// What the steps of the model hand on. Each is a function of its own so that a CPU may run it on packs: over lobes or
/// channels (chiang_quad.hpp) as over fibres (chiang_batch.hpp).
template <real_number Real>
struct chiang_section {
  interface_shares<Real> surface;  ///< Fresnel's F and 1 - F where the eye's ray enters
  Real radii;                      ///< length of one crossing of the fibre, in radii
  rotation<Real> entry;            ///< by 2γ_o
  rotation<Real> crossing;         ///< by 2γ_t + π
};

/// Refraction in the fibre's section at an offset h.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline chiang_section<Real> cross_chiang_section(Real eta, Real h, Real sin_o,
                                                                                   Real cos_o) noexcept {
  // sin γ_t = h/η′ with η′ = √(η² - sin²θ_o)/cos θ_o.
  const Real across = greatest(Real(-1), least(Real(1), h));
  const Real cos_gamma_o = square_root((Real(1) - across) * (Real(1) + across));
  const Real over_bent = Real(1) / square_root(greatest((eta - sin_o) * (eta + sin_o), Real(1e-36)));
  const Real sin_gamma_t = across * least(cos_o * over_bent, Real(1));
  const Real cos_gamma_t = square_root((Real(1) - sin_gamma_t) * (Real(1) + sin_gamma_t));
  // One crossing is 2 cos γ_t/cos θ_t long, and cos θ_t = √(η² - sin²θ_o)/η.
  return chiang_section<Real>{
      dielectric_interface(cos_o * cos_gamma_o, eta), Real(2) * cos_gamma_t * eta * over_bent,
      rotation<Real>{Real(1) - Real(2) * across * across, Real(2) * across * cos_gamma_o},
      rotation<Real>{Real(2) * sin_gamma_t * sin_gamma_t - Real(1), Real(-2) * sin_gamma_t * cos_gamma_t}};
}

/// A_0 to A_3 for one σ_a. [Chiang 2016 Eq. 6; d'Eon 2011 §3.2]
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline std::array<Real, 4> chiang_attenuation(const chiang_section<Real>& section,
                                                                                Real sigma_a) noexcept {
  const interface_shares<Real>& surface = section.surface;
  const Real depth = sigma_a * section.radii;
  const Real kept = exponential(Real(0) - depth);
  const Real turned_back = surface.reflected * kept;
  const Real passed = surface.transmitted * surface.transmitted * kept;
  // 1 - TF without cancellation; where it is 0 so is what it divides.
  const Real rest = surface.transmitted + surface.reflected * one_minus_exponential(depth);
  const Real returned = passed * turned_back;
  const Real residual = returned * turned_back / select(rest > Real(0), rest, Real(1));
  return std::array<Real, 4>{surface.reflected, passed, returned, residual};
}

}  // namespace detail

/// M of one lobe: `sum` holds cos and sin of θ_i + θ_o before the lobe's tilt.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real chiang_along(const longitudinal_lobe<Real>& lobe,
                                                           const rotation<Real>& sum, const rotation<Real>& tilt,
                                                           const rotation<Real>& tilted, Real flipped, Real sin_i,
                                                           Real cos_i) noexcept {
  // The tilt turns the sum of the inclinations, but where the tilted cosine has lost its sign.
  const Real product = cos_i * tilted.cosine;
  const rotation<Real> turned = turned_by(sum, tilt);
  const rotation<Real> between = {select(flipped > Real(0), product - sin_i * tilted.sine, turned.cosine),
                                  select(flipped > Real(0), sin_i * tilted.cosine + cos_i * tilted.sine, turned.sine)};
  return evaluate_longitudinal(lobe, inclination_pair<Real>{versine(between), product});
}

/// N of one lobe round its middle.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline Real chiang_round(const azimuthal_lobe<Real>& lobe,
                                                           const rotation<Real>& middle, Real y, Real z) noexcept {
  return evaluate_azimuthal(lobe,
                            unsigned_angle(middle.cosine * z - middle.sine * y, middle.cosine * y + middle.sine * z));
}

template <real_number Real>
chiang_fibre<Real> make_chiang_fibre(const chiang_parameters<Real>& parameters) noexcept {
  chiang_fibre<Real> fibre;
  fibre.eta = parameters.eta;
  for (std::uint32_t c = 0u; c < 3u; ++c) {
    fibre.sigma_a[c] = least(parameters.sigma_a[c], Real(1e30));
  }
  fibre.tints = std::array<Real, 4>{Real(1), Real(1), Real(1), Real(1)};
  const Real v = longitudinal_variance(parameters.beta_m);
  fibre.longitudinal[0] = make_longitudinal_lobe(v);
  fibre.longitudinal[1] = make_longitudinal_lobe(Real(0.25) * v);
  fibre.longitudinal[2] = make_longitudinal_lobe(Real(4) * v);
  fibre.longitudinal[3] = fibre.longitudinal[2];
  fibre.azimuthal = make_azimuthal_lobe(azimuthal_scale(parameters.beta_n));
  const rotation<Real> once = rotation_by(parameters.tilt);
  const rotation<Real> twice = turned_by(once, once);
  fibre.tilts =
      std::array<rotation<Real>, 3>{rotation<Real>{twice.cosine, Real(0) - twice.sine}, once, turned_by(twice, twice)};
  return fibre;
}

template <real_number Real>
chiang_view<Real> view_chiang(const chiang_fibre<Real>& fibre, Real h, const fibre_direction<Real>& eye) noexcept {
  chiang_view<Real> view;
  view.eye = eye;
  for (std::uint32_t p = 0u; p < 3u; ++p) {
    const rotation<Real> turned = turned_by(rotation<Real>{eye.cosine, eye.sine}, fibre.tilts[p]);
    view.flipped[p] = select(turned.cosine < Real(0), Real(1), Real(0));
    view.tilted[p] = rotation<Real>{absolute(turned.cosine), turned.sine};
  }
  const detail::chiang_section<Real> section = detail::cross_chiang_section(fibre.eta, h, eye.sine, eye.cosine);
  view.towards[0] = turned_back(rotation<Real>{eye.y, eye.z}, section.entry);
  view.towards[1] = turned_by(view.towards[0], section.crossing);
  view.towards[2] = turned_by(view.towards[1], section.crossing);

  std::array<Real, 4> sums = {Real(0), Real(0), Real(0), Real(0)};
  for (std::uint32_t c = 0u; c < 3u; ++c) {
    const std::array<Real, 4> path = detail::chiang_attenuation(section, fibre.sigma_a[c]);
    for (std::uint32_t p = 0u; p < 4u; ++p) {
      view.attenuation[p][c] = fibre.tints[p] * path[p];
      sums[p] = sums[p] + view.attenuation[p][c];
    }
  }
  const Real total = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  const Real over = Real(1) / select(total > Real(0), total, Real(1));
  for (std::uint32_t p = 0u; p < 4u; ++p) {
    view.weights[p] = sums[p] * over;
  }
  return view;
}

template <real_number Real>
chiang_result<Real> evaluate_chiang(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                                    const fibre_direction<Real>& light) noexcept {
  const std::array<Real, 4> lobes = chiang_lobes(fibre, view, light);
  chiang_result<Real> result = {glm::vec<3, Real>(Real(0)), Real(0)};
  for (std::uint32_t p = 0u; p < 4u; ++p) {
    result.value.x = result.value.x + lobes[p] * view.attenuation[p][0];
    result.value.y = result.value.y + lobes[p] * view.attenuation[p][1];
    result.value.z = result.value.z + lobes[p] * view.attenuation[p][2];
    result.density = result.density + lobes[p] * view.weights[p];
  }
  return result;
}

template <real_number Real>
std::array<Real, 4> chiang_inclinations(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                                        const fibre_direction<Real>& light) noexcept {
  const fibre_direction<Real>& eye = view.eye;
  const rotation<Real> sum = {light.cosine * eye.cosine - light.sine * eye.sine,
                              sine_of_sum(light.sine, light.cosine, eye.sine, eye.cosine)};
  std::array<Real, 4> along;
  for (std::uint32_t p = 0u; p < 3u; ++p) {
    along[p] = chiang_along(fibre.longitudinal[p], sum, fibre.tilts[p], view.tilted[p], view.flipped[p], light.sine,
                            light.cosine);
  }
  const rotation<Real> none = {Real(1), Real(0)};
  along[3] = chiang_along(fibre.longitudinal[3], sum, none, rotation<Real>{eye.cosine, eye.sine}, Real(0), light.sine,
                          light.cosine);
  return along;
}

template <real_number Real>
std::array<Real, 4> chiang_lobes(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                                 const fibre_direction<Real>& light) noexcept {
  std::array<Real, 4> lobes = chiang_inclinations(fibre, view, light);
  for (std::uint32_t p = 0u; p < 3u; ++p) {
    lobes[p] = lobes[p] * chiang_round(fibre.azimuthal, view.towards[p], light.y, light.z);
  }
  lobes[3] = lobes[3] * Real(0.159154943091895336);
  return lobes;
}

template <real_number Real>
Real chiang_density(const chiang_fibre<Real>& fibre, const chiang_view<Real>& view,
                    const fibre_direction<Real>& light) noexcept {
  const std::array<Real, 4> lobes = chiang_lobes(fibre, view, light);
  return ((lobes[0] * view.weights[0] + lobes[1] * view.weights[1]) + lobes[2] * view.weights[2]) +
         lobes[3] * view.weights[3];
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
