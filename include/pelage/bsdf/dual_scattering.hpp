// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// Light that many fibres have scattered before it reaches the eye, from averages of one fibre: forward through the
/// fibres in front (global), and back from those behind (local). [Zinke 2008]
///
/// Everything is in shares of light per steradian, e: what one fibre, or the hair behind it, sends from inclination
/// θ_i to (θ_r, φ), with ∫ e dω = the share that is scattered at all. For Chiang's model e is f |cos|, for Marschner's
/// ½ S cos θ_r, since its M counts θ_r in halves. φ is the azimuth between light and eye, 0 back to the light, ±π
/// straight on. The averages come from any fibre model: dual_scattering_table.hpp.
///
/// Where the paper is constant over a half circle of azimuths, 1/π here and 0 there, these are linear in |φ|: the same
/// share of light and no edge. 1/π is in e and not left to the caller.

/// What a fibre does on average to light of one inclination; colours are per channel.
template <std::floating_point Real>
struct dual_averages {
  glm::vec<3, Real> forward;            ///< ā_f: the share that goes on, [0, 1) if the model keeps energy
  glm::vec<3, Real> backward;           ///< ā_b: the share that turns back, in the same way
  glm::vec<3, Real> forward_shift;      ///< ᾱ_f: mean of θ_h = (θ_i + θ_r)/2 of what goes on, radians
  glm::vec<3, Real> backward_shift;     ///< ᾱ_b
  glm::vec<3, Real> forward_variance;   ///< β̄_f²: variance of θ_h of what goes on
  glm::vec<3, Real> backward_variance;  ///< β̄_b²
};

/// How dense hair is about a fibre: the chance that light finds a next fibre. The paper takes 0.7 for both, and twice
/// Ā_b d_b of the light from behind. A random walk through layers of parallel fibres sends back 0.8 to 1 of Ā_b, which
/// is d_b of 0.4 to 0.5.
template <std::floating_point Real>
struct dual_density {
  Real forward;   ///< d_f, [0, 1]
  Real backward;  ///< d_b, [0, 1]
};

/// Light back from the hair behind a fibre: what many inner reflections leave.
template <std::floating_point Real>
struct dual_local {
  glm::vec<3, Real> albedo;    ///< Ā_b, [0, inf)
  glm::vec<3, Real> shift;     ///< Δ̄_b in θ_h, radians
  glm::vec<3, Real> variance;  ///< σ̄_b² in θ_h
};

/// Light forward through the hair in front of a fibre.
template <std::floating_point Real>
struct dual_global {
  Real direct;                    ///< the share of the light that meets no fibre on its way, [0, 1]
  glm::vec<3, Real> transmitted;  ///< what arrives after fibres, direct light not counted, [0, 1]
  glm::vec<3, Real> variance;     ///< σ̄_f² that they have added, in θ_h
};

/// Local multiple scattering of a fibre with such averages. ā_f is clamped to 0.99: at 1 light would never be lost
/// between two fibres and the sums diverge. [Zinke 2008 Eqs. 14 to 18]
template <std::floating_point Real>
[[nodiscard]] dual_local<Real> dual_local_scattering(const dual_averages<Real>& averages,
                                                     const dual_density<Real>& density) noexcept;

/// Before any fibre: all light is direct.
template <std::floating_point Real>
[[nodiscard]] dual_global<Real> dual_unshadowed() noexcept {
  return dual_global<Real>{Real(1), glm::vec<3, Real>(Real(0)), glm::vec<3, Real>(Real(0))};
}

/// Global multiple scattering, the real-time form: what `count` fibres leave of the light, all taken to be alike.
/// [Zinke 2008 §4.1, Eqs. 4 to 8]
///
/// `count`: fibres between the light and the point, [0, inf), as an opacity map or deep shadow map counts them;
/// fractions are blends. `direct`: transmittance of the same path for opaque fibres, [0, 1]; where nothing better is
/// known, e^-count. A fibre that is met with the chance d_f passes ā_f of the light.
template <std::floating_point Real>
[[nodiscard]] dual_global<Real> dual_global_scattering(const dual_averages<Real>& averages,
                                                       const dual_density<Real>& density, Real count,
                                                       Real direct) noexcept;

/// One fibre more on a traced path, each with its own averages: start from dual_unshadowed(). [Zinke 2008 Eq. 5]
/// After it no light is direct.
template <std::floating_point Real>
[[nodiscard]] dual_global<Real> dual_pass_fibre(const dual_global<Real>& before, const dual_averages<Real>& averages,
                                                const dual_density<Real>& density) noexcept;

/// What reaches the eye from a fibre, e for red, green, blue: direct light scattered once and from behind, and
/// scattered light in the same way, its lobes widened. [Zinke 2008 Fig. 9]
///
/// `single`: e of the fibre model for the direct light. `theta_i`, `theta_r` in (-π/2, π/2), `phi` in [-π, π].
template <std::floating_point Real>
[[nodiscard]] glm::vec<3, Real> dual_scattering(const dual_averages<Real>& averages, const dual_local<Real>& local,
                                                const dual_global<Real>& global, const dual_density<Real>& density,
                                                const glm::vec<3, Real>& single, Real theta_i, Real theta_r,
                                                Real phi) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// The share per steradian of a lobe: a Gaussian in θ_h and linear in |φ|, forward (largest at ±π) or backward (at 0);
/// integrates to 1 over the sphere except for what a wide Gaussian leaves beyond ±π/2.
template <std::floating_point Real>
[[nodiscard]] Real dual_lobe(Real theta_h, Real variance, Real cos_theta_r, Real share_of_azimuth) noexcept {
  const Real v = greatest(variance, Real(1e-8));
  // ½ since θ_r is twice θ_h; 1/π for the half circle.
  const Real gauss = exponential(Real(-0.5) * theta_h * theta_h / v) * Real(0.398942280401432678) / square_root(v);
  return Real(0.159154943091895336) * gauss * share_of_azimuth / greatest(cos_theta_r, Real(1e-4));
}

}  // namespace detail

template <std::floating_point Real>
dual_local<Real> dual_local_scattering(const dual_averages<Real>& averages,
                                       const dual_density<Real>& density) noexcept {
  dual_local<Real> local;
  for (int c = 0; c < 3; ++c) {
    const Real f = least(averages.forward[c], Real(0.99));
    const Real b = averages.backward[c];
    const Real f2 = f * f;
    const Real b2 = b * b;
    const Real lost = Real(1) - f2;
    const Real lost2 = lost * lost;
    // One and three backward scatterings; an even number goes on.
    local.albedo[c] = b * f2 / lost + b * b2 * f2 / (lost * lost2);
    local.shift[c] = averages.backward_shift[c] * (Real(1) - Real(2) * b2 / lost2) +
                     averages.forward_shift[c] * (Real(2) * lost2 + Real(4) * f2 * b2) / (lost * lost2);
    const Real beta_f2 = averages.forward_variance[c];
    const Real beta_b2 = averages.backward_variance[c];
    const Real spread =
        b * std::sqrt(Real(2) * beta_f2 + beta_b2) + b * b2 * std::sqrt(Real(2) * beta_f2 + Real(3) * beta_b2);
    const Real weight = b + b * b2 * (Real(2) * std::sqrt(beta_f2) + Real(3) * std::sqrt(beta_b2));
    const Real deviation = b > Real(0) ? (Real(1) + density.backward * f2) * spread / weight : std::sqrt(beta_b2);
    local.variance[c] = deviation * deviation;
  }
  return local;
}

template <std::floating_point Real>
dual_global<Real> dual_global_scattering(const dual_averages<Real>& averages, const dual_density<Real>& density,
                                         Real count, Real direct) noexcept {
  dual_global<Real> global;
  global.direct = least(greatest(direct, Real(0)), Real(1));
  const Real fibres = greatest(count, Real(0));
  for (int c = 0; c < 3; ++c) {
    const Real kept = power_of_share(averages.forward[c], fibres);
    global.transmitted[c] = density.forward * greatest(kept - global.direct, Real(0));
    global.variance[c] = fibres * averages.forward_variance[c];
  }
  return global;
}

template <std::floating_point Real>
dual_global<Real> dual_pass_fibre(const dual_global<Real>& before, const dual_averages<Real>& averages,
                                  const dual_density<Real>& density) noexcept {
  dual_global<Real> after;
  after.direct = Real(0);
  after.transmitted = (before.transmitted + density.forward * before.direct) * averages.forward;
  after.variance = before.variance + averages.forward_variance;
  return after;
}

template <std::floating_point Real>
glm::vec<3, Real> dual_scattering(const dual_averages<Real>& averages, const dual_local<Real>& local,
                                  const dual_global<Real>& global, const dual_density<Real>& density,
                                  const glm::vec<3, Real>& single, Real theta_i, Real theta_r, Real phi) noexcept {
  const Real theta_h = Real(0.5) * (theta_i + theta_r);
  const Real cosine = rotation_by(theta_r).cosine;
  const Real onward = least(absolute(phi) * Real(0.318309886183790672), Real(1));
  const Real back = Real(1) - onward;
  glm::vec<3, Real> sum;
  for (int c = 0; c < 3; ++c) {
    const Real sigma2 = global.variance[c];
    const Real from_behind = Real(2) * density.backward * local.albedo[c];
    const Real direct =
        single[c] + from_behind * detail::dual_lobe(theta_h - local.shift[c], local.variance[c], cosine, back);
    const Real scattered =
        averages.forward[c] * detail::dual_lobe(theta_h - averages.forward_shift[c],
                                                averages.forward_variance[c] + sigma2, cosine, onward) +
        averages.backward[c] * detail::dual_lobe(theta_h - averages.backward_shift[c],
                                                 averages.backward_variance[c] + sigma2, cosine, back) +
        from_behind * detail::dual_lobe(theta_h - local.shift[c], local.variance[c] + sigma2, cosine, back);
    sum[c] = global.direct * direct + global.transmitted[c] * scattered;
  }
  return sum;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
