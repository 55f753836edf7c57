// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/interface.hpp>
#include <pelage/bsdf/scattering_roots.hpp>
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <concepts>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// Hair seen from afar, light averaged over a fibre's width: R, TT and TRT as Gaussians along the fibre times exact
/// optics of a smooth circular section round it. [Marschner 2003]
///
/// Angles in radians. θ is the inclination from the plane at right angles to the fibre, φ the azimuth between the two
/// directions, both of which point away from the fibre. The reflection of a lobe is M_p(θ_h) N_p(θ_d, φ)/cos²θ_d.
/// How TRT's caustic is treated: the bare sum over roots is infinite there.
template <std::floating_point Real>
struct caustic_treatment {
  bool smoothed;   ///< false leaves the bare sum, clamped to |dφ/dγ| ≥ 2e-6; the rest is then unused
  Real width;      ///< w_c, standard deviation of what replaces it, (0, inf); paper 0.17 to 0.44
  Real limit;      ///< Δh_M, greatest share of the width that goes there, [0, 2]; paper 0.5
  Real intensity;  ///< k_G, [0, inf); 1 keeps about the energy taken, paper 0.5 to 5
  Real fade;       ///< Δη′, over which the caustic fades beyond η′ = 2, (0, inf); paper 0.2 to 0.4
};

/// A fibre and its surface.
template <std::floating_point Real>
struct marschner_parameters {
  Real eta;                     ///< index of refraction, [1, inf); hair 1.55
  std::array<Real, 3> sigma_a;  ///< absorption per fibre radius, [0, inf)
  Real alpha;                   ///< shift of R in θ_h, + to the tip, hair -0.17 to -0.09; TT has -α/2, TRT -3α/2
  Real beta;                    ///< standard deviation of R along the fibre, (0, inf); TT has β/2, TRT 2β
  Real eccentricity;            ///< ratio of the section's axes, 1 round, hair 0.85 to 1; bends TRT only
  caustic_treatment<Real> caustic;
};

/// One evaluation, with its parts.
template <std::floating_point Real>
struct marschner_result {
  std::array<Real, 3> longitudinal;            ///< M of R, TT, TRT, per radian
  std::array<glm::vec<3, Real>, 3> azimuthal;  ///< N of R, TT, TRT, each for red, green, blue, per radian
  glm::vec<3, Real> scattering;                ///< S for red, green, blue: Σ M N/cos²θ_d; times light · cos θ_i
};

/// The values that the paper takes for hair: η 1.55, α -0.12 (7°), β 0.13 (7.5°), round, caustic 0.26, 0.5, 1, 0.3.
template <std::floating_point Real>
[[nodiscard]] marschner_parameters<Real> common_marschner_parameters(const std::array<Real, 3>& sigma_a) noexcept {
  return marschner_parameters<Real>{Real(1.55), sigma_a, Real(-0.12),
                                    Real(0.13), Real(1), {true, Real(0.26), Real(0.5), Real(1), Real(0.3)}};
}

/// What the azimuthal part needs of θ_d: Bravais indices and the length of inner paths.
template <std::floating_point Real>
struct fibre_section {
  Real eta_perpendicular;  ///< η′ = √(η² - sin²θ_d)/cos θ_d
  Real eta_parallel;       ///< η″ = η²/η′
  Real excess;             ///< η′² - 1 = (η² - 1)/cos²θ_d
  Real path_stretch;       ///< 1/cos θ_t, sin θ_t = sin θ_d/η
};

/// The section of a fibre of index eta at a difference angle; cos θ_d is clamped to at least 1e-6.
template <std::floating_point Real>
[[nodiscard]] fibre_section<Real> make_fibre_section(Real eta, Real theta_d) noexcept;

/// The whole model. `theta_i`, `theta_r` in [-π/2, π/2], `phi` any, `phi_h` = (φ_i + φ_r)/2 from the section's long
/// axis, of no effect on a round fibre. Float within 2e-3 of double where values exceed 1e-6 and |dφ/dh| ≥ 0.2 at
/// each root, for η in [1.1, 1.9], |α| ≤ 0.2, β in [0.02, 0.5], inclinations within ±1.55, φ within ±3.1415 and σ_a up
/// to 10; 999 in 1000 values within 2e-5.
template <std::floating_point Real>
[[nodiscard]] marschner_result<Real> evaluate_marschner(const marschner_parameters<Real>& parameters, Real theta_i,
                                                        Real theta_r, Real phi, Real phi_h) noexcept;

// ---------------------------------------------------------------------------------------------------------

/// A(p, h): what is left of light on path p, for one channel: F, or (1 - F)² F^(p-1) Tᵖ. [Marschner 2003 Eq. 8]
template <std::floating_point Real>
[[nodiscard]] Real path_attenuation(const fibre_section<Real>& section, int path, Real sin_gamma, Real cos_gamma,
                                    Real sigma_a) noexcept {
  const Real sin_inside = sin_gamma / section.eta_perpendicular;
  const Real cos_inside = square_root((Real(1) - sin_inside) * (Real(1) + sin_inside));
  const interface_shares<Real> surface =
      bravais_interface(cos_gamma, cos_inside, section.eta_perpendicular, section.eta_parallel);
  const Real depth = Real(2) * sigma_a * section.path_stretch * cos_inside;
  const Real passed = surface.transmitted * surface.transmitted * exponential(Real(0) - Real(path) * depth);
  const Real inner = path == 2 ? surface.reflected : Real(1);
  return path == 0 ? surface.reflected : passed * inner;
}

/// The same for red, green, blue.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> colour_attenuation(const fibre_section<Real>& section, int path, Real sin_gamma,
                                                   Real cos_gamma, const std::array<Real, 3>& sigma_a) noexcept {
  return glm::vec<3, Real>(path_attenuation(section, path, sin_gamma, cos_gamma, sigma_a[0]),
                           path_attenuation(section, path, sin_gamma, cos_gamma, sigma_a[1]),
                           path_attenuation(section, path, sin_gamma, cos_gamma, sigma_a[2]));
}

/// N_p(θ_d, φ) per radian and channel by summing A/|2 dφ/dh| over the path's roots, no caustic treatment; 0 without
/// roots. ∫ N_p dφ is ½ ∫ A(p, h) dh.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> bare_azimuthal(const fibre_section<Real>& section, int path, Real phi,
                                               const std::array<Real, 3>& sigma_a) noexcept {
  const scattering_roots<Real> roots = find_scattering_roots(path, phi, section.excess);
  glm::vec<3, Real> sum = glm::vec<3, Real>(Real(0));
  for (std::uint32_t k = 0u; k < 3u; ++k) {
    if (k < roots.count) {
      const scattering_root<Real> root = roots.root[k];
      const Real density = root.cosine / (Real(4) * greatest(absolute(root.slope), Real(1e-6)));
      sum = sum + density * colour_attenuation(section, path, root.sine, root.cosine, sigma_a);
    }
  }
  return sum;
}

/// A Gaussian of unit integral.
template <std::floating_point Real>
[[nodiscard]] Real gaussian(Real x, Real deviation) noexcept {
  const Real z = x / deviation;
  return exponential(Real(-0.5) * z * z) * (Real(0.398942280401432678) / deviation);
}

/// N_TRT with its caustic faded out and a Gaussian of the same energy put in. [Marschner 2003 App. B]
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> smooth_trt(const fibre_section<Real>& section, Real phi,
                                           const std::array<Real, 3>& sigma_a,
                                           const caustic_treatment<Real>& caustic) noexcept {
  const Real eta = section.eta_perpendicular;
  const caustic_point<Real> point = find_caustic(section.excess);
  const Real phi_c = Real(2) * point.half_azimuth;
  // dφ/dh is 0 there, so d²φ/dh² is 2 d²(φ/2)/dγ² over cos²γ.
  const Real bend = Real(2) * point.curvature / greatest(point.cosine * point.cosine, Real(1e-12));
  const Real wide = bend > Real(0) ? Real(2) * square_root(Real(2) * caustic.width / bend) : caustic.limit;
  const Real width = least(caustic.limit, wide);
  const Real beyond = saturate((eta - Real(2)) / caustic.fade);
  const Real strength = Real(1) - beyond * beyond * (Real(3) - Real(2) * beyond);
  const Real azimuth = wrapped_angle(phi);
  const Real peak = gaussian(Real(0), caustic.width);
  const Real right = gaussian(wrapped_angle(azimuth - phi_c), caustic.width);
  const Real left = gaussian(wrapped_angle(azimuth + phi_c), caustic.width);
  const Real kept = (Real(1) - strength * right / peak) * (Real(1) - strength * left / peak);
  const Real put = strength * caustic.intensity * width * (right + left);
  return bare_azimuthal(section, 2, phi, sigma_a) * kept +
         put * colour_attenuation(section, 2, point.sine, point.cosine, sigma_a);
}

/// N_TRT, its caustic as the treatment says.
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> treated_trt(const fibre_section<Real>& section, Real phi,
                                            const std::array<Real, 3>& sigma_a,
                                            const caustic_treatment<Real>& caustic) noexcept {
  if (caustic.smoothed) {
    return smooth_trt(section, phi, sigma_a, caustic);
  }
  return bare_azimuthal(section, 2, phi, sigma_a);
}

/// The index that makes a round fibre refract like an elliptic one lit at the azimuth φ_h from its long axis.
/// `ratio` a: of the axes, (0, inf), 1 gives eta. [Marschner 2003 §5.2.3]
template <std::floating_point Real>
[[nodiscard]] Real eccentric_index(Real eta, Real ratio, Real phi_h) noexcept {
  const Real along = Real(2) * (eta - Real(1)) * ratio * ratio - eta + Real(2);
  const Real across = Real(2) * (eta - Real(1)) / (ratio * ratio) - eta + Real(2);
  return Real(0.5) * ((along + across) + rotation_by(Real(2) * wrapped_angle(phi_h)).cosine * (along - across));
}

template <std::floating_point Real>
fibre_section<Real> make_fibre_section(Real eta, Real theta_d) noexcept {
  const rotation<Real> angle = rotation_by(theta_d);
  const Real cosine = greatest(angle.cosine, Real(1e-6));
  // η′² = 1 + (η² - 1)/cos²θ_d: a sum of positive terms.
  const Real excess = (eta - Real(1)) * (eta + Real(1)) / (cosine * cosine);
  const Real eta_perpendicular = square_root(Real(1) + excess);
  return fibre_section<Real>{eta_perpendicular, eta * eta / eta_perpendicular, excess,
                             eta / (eta_perpendicular * cosine)};
}

template <std::floating_point Real>
marschner_result<Real> evaluate_marschner(const marschner_parameters<Real>& parameters, Real theta_i, Real theta_r,
                                          Real phi, Real phi_h) noexcept {
  const Real theta_h = Real(0.5) * (theta_i + theta_r);
  const Real theta_d = Real(0.5) * (theta_r - theta_i);
  const fibre_section<Real> section = make_fibre_section(parameters.eta, theta_d);
  marschner_result<Real> result;
  result.longitudinal[0] = gaussian(theta_h - parameters.alpha, parameters.beta);
  result.longitudinal[1] = gaussian(theta_h + Real(0.5) * parameters.alpha, Real(0.5) * parameters.beta);
  result.longitudinal[2] = gaussian(theta_h + Real(1.5) * parameters.alpha, Real(2) * parameters.beta);
  result.azimuthal[0] = bare_azimuthal(section, 0, phi, parameters.sigma_a);
  result.azimuthal[1] = bare_azimuthal(section, 1, phi, parameters.sigma_a);
  const Real bent = greatest(eccentric_index(parameters.eta, parameters.eccentricity, phi_h), Real(1));
  const fibre_section<Real> bent_section = make_fibre_section(bent, theta_d);
  result.azimuthal[2] = treated_trt(bent_section, phi, parameters.sigma_a, parameters.caustic);
  const Real cosine = greatest(rotation_by(theta_d).cosine, Real(1e-6));
  glm::vec<3, Real> sum = glm::vec<3, Real>(Real(0));
  for (std::uint32_t p = 0u; p < 3u; ++p) {
    sum = sum + result.longitudinal[p] * result.azimuthal[p];
  }
  result.scattering = sum / (cosine * cosine);
  return result;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
