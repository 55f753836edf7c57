// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/tail.hpp>
#include <pelage/composite/transmittance.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <concepts>

namespace pelage::inline PELAGE_ABI {

/// A pixel's radiance while its fibres are added front to back: Σ (1 - Aᵢ) Cᵢ Lᵢ Π_{j<i} (Aⱼ Cⱼ + 1 - Cⱼ).
/// [Yu12 Eq. 5, which has no (1 - Aᵢ) Cᵢ] A fibre scatters toward the eye the share of the light that it stops: without
/// that factor one that covers a hundredth of the pixel would be as bright as one that fills it. So with L = 1
/// everywhere, background included, the pixel is 1 whatever lies in it.
template <std::floating_point Real>
struct pixel_radiance {
  glm::vec<3, Real> radiance;       ///< gathered so far, linear RGB
  glm::vec<3, Real> transmittance;  ///< of all fibres so far, [0, 1] a channel
};

/// A pixel with nothing in it.
template <std::floating_point Real>
[[nodiscard]] constexpr pixel_radiance<Real> empty_pixel() noexcept {
  return pixel_radiance<Real>{glm::vec<3, Real>(Real(0)), glm::vec<3, Real>(Real(1))};
}

/// The pixel with one more fibre behind the others. `scattered` L: what the fibre sends to the eye, linear RGB.
/// `attenuation` A and `coverage` C as in transmittance(). O(1).
template <std::floating_point Real>
[[nodiscard]] constexpr pixel_radiance<Real> add_fibre(const pixel_radiance<Real>& pixel,
                                                       const glm::vec<3, Real>& scattered,
                                                       const glm::vec<3, Real>& attenuation, Real coverage) noexcept;

/// The pixel with a tail behind its fibres: one more layer, of the tail's mean colour and transmittance, that covers
/// the whole pixel. If the tail's colours were divided by a white, divide every `scattered` by it, too, and
/// multiply what resolve() gives.
[[nodiscard]] inline pixel_radiance<float> add_tail(const pixel_radiance<float>& pixel, const tail& behind) noexcept {
  return add_fibre(pixel, mean_colour(behind), glm::vec3(transmittance_of(behind)), 1.0f);
}

/// What is seen of the pixel in front of a background, linear RGB.
template <std::floating_point Real>
[[nodiscard]] constexpr glm::vec<3, Real> resolve(const pixel_radiance<Real>& pixel,
                                                  const glm::vec<3, Real>& background) noexcept {
  return pixel.radiance + pixel.transmittance * background;
}

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
constexpr pixel_radiance<Real> add_fibre(const pixel_radiance<Real>& pixel, const glm::vec<3, Real>& scattered,
                                         const glm::vec<3, Real>& attenuation, Real coverage) noexcept {
  const glm::vec<3, Real> stopped = (Real(1) - attenuation) * coverage;
  return pixel_radiance<Real>{pixel.radiance + pixel.transmittance * stopped * scattered,
                              pixel.transmittance * transmittance(attenuation, coverage)};
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
