// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang_quad.hpp>
#include <pelage/bsdf/dual_scattering.hpp>
#include <pelage/bsdf/hair_parameters.hpp>
#include <pelage/bsdf/marschner.hpp>

#include <glm/vec3.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "frame/base/wide.hpp"
#include "frame/raster/view_opacity.hpp"
#include "frame/shading/azimuthal_table.hpp"
#include "frame/shadows/shadow_map.hpp"

namespace pelage::frame {

enum class bsdf_model {
  kajiya_kay,      ///< a coloured diffuse and a white highlight
  marschner,       ///< one scattering in a smooth fibre
  chiang,          ///< one scattering in a rough fibre, averaged over its width
  dual_scattering  ///< the same, and what the hair in front and behind scatters
};

/// How fibres answer light.
struct fibre_look {
  bsdf_model model = bsdf_model::kajiya_kay;
  std::optional<melanin<float>> pigment;  ///< [0, 100] each; none: the fibres' own colour
  float eta = 1.55F;                      ///< index of refraction, [1, 3]
  float beta_m = 0.2F;                    ///< roughness along, [0.05, 1]; 0.2 is Marschner's β of 5°, 0.3 of 8°
  float beta_n = 0.3F;                    ///< roughness round, [0.05, 1]; Marschner's fibre has none
  float tilt = 2.0F;                      ///< of the cuticle's scales toward the tip, degrees, [-20, 20]
  attenuation passing = attenuation::constant;
  // Kajiya-Kay's. Its lobes have no physical weights; these look like hair.
  float diffuse = 0.55F;   ///< K_d, on the fibre's colour, [0, 100]
  float specular = 0.22F;  ///< K_s, white, [0, 100]
  float exponent = 60.0F;  ///< p, [0, 10000]
};

/// A place on a fibre and who looks at it; as many as Real has lanes.
template <class Real>
struct fibre_place_of {
  glm::vec<3, Real> tangent;  ///< unit, root to tip
  glm::vec<3, Real> to_eye;   ///< unit
  glm::vec<3, Real> colour;   ///< the fibre's own, linear RGB reflectance
  Real opacity;               ///< the share of the light across its width that it meets, [0, 1]
};
using fibre_place = fibre_place_of<float>;

/// A fibre's scattering, ready for use. Every result is finite and not negative, for any vectors.
///
/// Units: a light's colour is the radiance of a white wall that faces it, so its irradiance is π times that, and sky
/// is a radiance. A fibre without pigment that is lit evenly from all sides is then as bright as what lights it.
///
/// Consistency: a fibre of opacity α meets the share α of the light across it and scatters what it meets by the whole
/// BSDF, TT lobe included; 1 - α passes untouched, and along the view path nothing else does, since what a fibre in
/// front sends on to the eye is its own TT lobe, lit through the fibres behind it. Along the shadow path light comes
/// untouched (the map's transmittance T) or through fibres that it met. A fibre passes the share a of what it meets,
/// the integral of the TT lobe [passage.hpp], so that in all T^(1 - a) comes, per channel: fibres thin or few a texel
/// multiply 1 - αc(1 - a). Dual scattering takes ā_f, which is all that goes on, to the power of the fibres' number,
/// and widens the lobes by what those have spread. So no light is counted twice: all light through n fibres,
/// added up over the fibre that was the last, is what a fibre passes to the power of n.
///
/// With attenuation::fresnel 1 - α is A, by the inclination to each light and to the eye, and the TT lobe's part of a
/// path is in it: just T comes [Yu12 Eq. 3]. It has no colour, and dual scattering, which counts fibres, none of it.
class fibre_bsdf {
 public:
  /// `own_colour`: mean reflectance of the fibres. Without a pigment Kajiya-Kay takes each place's own instead, and the
  /// others absorb so much that a mass of them reflects this. [hair_parameters.hpp]
  /// Throws std::invalid_argument for a look with a value out of its range.
  fibre_bsdf(const fibre_look& look, const glm::vec3& own_colour);

  /// Radiance toward the eye for light of unit colour; `passed`: what it has met on its way.
  [[nodiscard]] glm::vec3 scatter(const fibre_place& at, const glm::vec3& to_light, const passage& passed) const;

  /// Radiance toward the eye where radiance 1 comes from all sides, but from the eye's side most, 2(1 - |φ|/π): an eye
  /// that sees a fibre looks along the way by which the sky lights it, and hair lies behind.
  [[nodiscard]] glm::vec3 reflect_sky(const fibre_place& at) const;

  /// The same for the lanes whose bit is set, each with the bits that its place has alone; garbage in the others.
  [[nodiscard]] wide3 scatter(const fibre_place_of<wide>& at, const wide3& to_light, const passage_of<wide>& passed,
                              std::uint32_t set) const;
  [[nodiscard]] wide3 reflect_sky(const fibre_place_of<wide>& at, std::uint32_t set) const;

  /// What another device needs for the same results: the colour of a pigment's hair for Kajiya-Kay; the models ready
  /// for use; N, null for Kajiya-Kay; averages at the middles of equal steps from -π/2 to π/2 for dual scattering, else
  /// empty.
  [[nodiscard]] std::optional<glm::vec3> pigment_colour() const {
    return look_.pigment ? std::optional(mass_albedo_) : std::nullopt;
  }
  [[nodiscard]] const marschner_parameters<float>& marschner() const { return marschner_; }
  [[nodiscard]] const chiang_fibre<float>& chiang() const { return fibre_; }
  [[nodiscard]] const azimuthal_table* table() const { return table_ ? &*table_ : nullptr; }
  [[nodiscard]] std::span<const dual_averages<float>> averages() const { return averages_; }
  static constexpr std::uint32_t inclinations = 48;  ///< of averages

 private:
  /// Both directions as the models take them.
  struct angles {
    float sin_light, cos_light, sin_eye, cos_eye;  ///< of the inclinations
    float phi;                                     ///< azimuth between them, [0, π]
  };

  [[nodiscard]] static angles angles_of(const glm::vec3& tangent, const glm::vec3& to_light, const glm::vec3& to_eye);
  template <class Real>
  [[nodiscard]] glm::vec<3, Real> own_colour(const fibre_place_of<Real>& at) const;
  template <class Real>
  [[nodiscard]] glm::vec<3, Real> kajiya_kay_share(const fibre_place_of<Real>& at,
                                                   const glm::vec<3, Real>& to_light) const;
  [[nodiscard]] glm::vec3 marschner_share(const angles& a) const;
  [[nodiscard]] glm::vec3 chiang_share(const angles& a) const;
  [[nodiscard]] glm::vec3 dual_share(const angles& a, const passage& passed, float opacity) const;
  void average();

  fibre_look look_;
  glm::vec3 mass_albedo_;  ///< of hair with the look's pigment, if it has one
  marschner_parameters<float> marschner_;
  chiang_fibre<float> fibre_;
  chiang_quad_fibre chiang_;
  std::optional<azimuthal_table> table_;
  std::vector<dual_averages<float>> averages_;
};

}  // namespace pelage::frame
