// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/fibre_bsdf.hpp"

#include <pelage/bsdf/dual_scattering_table.hpp>
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/core/lanes.hpp>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pelage::frame {
namespace {

constexpr float pi = 3.14159265F;

constexpr dual_density<float> density{0.7F, 0.7F};  // [Zinke 2008 §5]

void check(const fibre_look& look) {
  const auto hold = [](float value, float least, float most, const char* what) {
    if (!(value >= least && value <= most)) {
      throw std::invalid_argument(fmt::format("{} must be in [{}, {}]", what, least, most));
    }
  };
  hold(look.eta, 1.0F, 3.0F, "the index of refraction");
  hold(look.beta_m, 0.05F, 1.0F, "a fibre's roughness");
  hold(look.beta_n, 0.05F, 1.0F, "a fibre's roughness");
  if (look.passing == attenuation::fresnel && look.model == bsdf_model::dual_scattering) {
    throw std::invalid_argument("--bsdf dual_scattering needs --attenuation constant");
  }
  hold(look.tilt, -20.0F, 20.0F, "the tilt of scales");
  hold(look.diffuse, 0.0F, 100.0F, "the diffuse weight");
  hold(look.specular, 0.0F, 100.0F, "the specular weight");
  hold(look.exponent, 0.0F, 10000.0F, "the highlight's exponent");
  if (look.pigment) {
    hold(look.pigment->eumelanin, 0.0F, 100.0F, "melanin");
    hold(look.pigment->pheomelanin, 0.0F, 100.0F, "melanin");
  }
}

std::array<float, 3> absorption(const fibre_look& look, const glm::vec3& own_colour) {
  if (look.pigment) return absorption_of(*look.pigment);
  return {absorption_from_albedo(own_colour.x, look.beta_n), absorption_from_albedo(own_colour.y, look.beta_n),
          absorption_from_albedo(own_colour.z, look.beta_n)};
}

glm::vec3 mass_albedo(const fibre_look& look) {
  const std::array<float, 3> sigma = absorption_of(look.pigment.value_or(melanin<float>{0.0F, 0.0F}));
  return {albedo_from_absorption(sigma[0], look.beta_n), albedo_from_absorption(sigma[1], look.beta_n),
          albedo_from_absorption(sigma[2], look.beta_n)};
}

// Scales that rise toward the tip turn normals toward the root, and +x is the tip.
marschner_parameters<float> marschner_of(const fibre_look& look, const std::array<float, 3>& sigma_a) {
  marschner_parameters<float> p = common_marschner_parameters(sigma_a);
  p.eta = look.eta;
  p.alpha = -glm::radians(look.tilt);
  p.beta = 0.5F * std::sqrt(longitudinal_variance(look.beta_m));  // θ_h is half of θ_i + θ_r
  return p;
}

chiang_fibre<float> chiang_of(const fibre_look& look, const std::array<float, 3>& sigma_a) {
  return make_chiang_fibre<float>({look.eta, sigma_a, look.beta_m, look.beta_n, -glm::radians(look.tilt)});
}

/// x clamped to [-1, 1]; -1 where it is NaN.
float held_sine(float x) {
  return std::min(std::max(-1.0F, x), 1.0F);
}

float cosine_of(float sine) {
  return square_root((1.0F - sine) * (1.0F + sine));
}

float sin_half_difference(float theta_from, float theta_to) {
  return rotation_by(0.5F * (theta_to - theta_from)).sine;
}

/// The light that arrives where a fibre passes the share `kept` of what it meets.
glm::vec3 arriving(const passage& passed, const glm::vec3& kept) {
  if (!(passed.transmittance > 0.0F)) return glm::vec3(0.0F);
  const float octaves = fast_log2(std::min(passed.transmittance / passed.open, 1.0F));
  const auto channel = [&](float a) { return passed.open * fast_exp2((1.0F - std::min(a, 1.0F)) * octaves); };
  return {channel(kept.x), channel(kept.y), channel(kept.z)};
}

}  // namespace

fibre_bsdf::fibre_bsdf(const fibre_look& look, const glm::vec3& own_colour) : look_(look) {
  check(look);
  mass_albedo_ = mass_albedo(look);
  const std::array<float, 3> sigma_a = absorption(look, own_colour);
  marschner_ = marschner_of(look, sigma_a);
  fibre_ = chiang_of(look, sigma_a);
  chiang_ = make_chiang_quad_fibre(fibre_);
  if (look.model == bsdf_model::marschner) table_.emplace(marschner_);
  if (look.model == bsdf_model::chiang || look.model == bsdf_model::dual_scattering) table_.emplace(fibre_);
  if (look.model == bsdf_model::dual_scattering) average();
}

/// What comes from one inclination of light is what an eye there would see of all: Chiang's model has the two change
/// places.
void fibre_bsdf::average() {
  constexpr float step = pi / static_cast<float>(inclinations);
  averages_.resize(inclinations);
  tbb::parallel_for(0U, inclinations, [&](std::uint32_t i) {
    const auto model = [this](float theta_i, float theta_r, float phi) {
      const rotation<float> from = rotation_by(theta_i);
      const rotation<float> to = rotation_by(theta_r);
      return chiang_share({to.sine, absolute(to.cosine), from.sine, absolute(from.cosine), phi});
    };
    averages_[i] = average_fibre(model, (static_cast<float>(i) + 0.5F) * step - 0.5F * pi, 256U, 64U);
  });
}

fibre_bsdf::angles fibre_bsdf::angles_of(const glm::vec3& tangent, const glm::vec3& to_light, const glm::vec3& to_eye) {
  const float sin_light = held_sine(glm::dot(tangent, to_light));
  const float sin_eye = held_sine(glm::dot(tangent, to_eye));
  const float across = absolute(glm::dot(tangent, glm::cross(to_light, to_eye)));
  const float along = glm::dot(to_light, to_eye) - sin_light * sin_eye;
  return {sin_light, cosine_of(sin_light), sin_eye, cosine_of(sin_eye), std::min(pi, unsigned_angle(across, along))};
}

template <class Real>
glm::vec<3, Real> fibre_bsdf::own_colour(const fibre_place_of<Real>& at) const {
  return look_.pigment ? filled<Real>(mass_albedo_) : at.colour;
}

template <class Real>
glm::vec<3, Real> fibre_bsdf::kajiya_kay_share(const fibre_place_of<Real>& at,
                                               const glm::vec<3, Real>& to_light) const {
  const auto lobes = kajiya_kay(at.tangent, to_light, at.to_eye, Real(look_.exponent));
  return Real(look_.diffuse) * lobes.diffuse * own_colour(at) +
         glm::vec<3, Real>(Real(look_.specular) * lobes.specular);
}

/// ½ S cos θ_i: half, since M counts θ_r in halves.
glm::vec3 fibre_bsdf::marschner_share(const angles& a) const {
  const float theta_i = angle_of_sine(a.sin_light);
  const float theta_r = angle_of_sine(a.sin_eye);
  const float theta_h = 0.5F * (theta_i + theta_r);
  const float sin_theta_d = sin_half_difference(theta_i, theta_r);
  const float cos2_theta_d = std::max((1.0F - sin_theta_d) * (1.0F + sin_theta_d), 1e-12F);
  const marschner_lobes<float> n = table_->lobes(sin_theta_d, a.phi);
  const auto m = [&](float shift, float width) {
    return gaussian(theta_h - shift * marschner_.alpha, width * marschner_.beta);
  };
  const glm::vec3 sum = m(1.0F, 1.0F) * n.reflected + m(-0.5F, 0.5F) * n.transmitted + m(-1.5F, 2.0F) * n.returned;
  return (0.5F * a.cos_light / cos2_theta_d) * sum;
}

/// Σ M_p N_p, f |cos| of chiang_far_field.hpp: four longitudinal lobes in four lanes, N by the table.
glm::vec3 fibre_bsdf::chiang_share(const angles& a) const {
  using pack = lanes<4>;
  const rotation<pack> turned = turned_by(rotation<pack>{pack(a.cos_eye), pack(a.sin_eye)}, chiang_.tilts);
  const rotation<pack> tilted = {absolute(turned.cosine), turned.sine};
  const pack flipped = select(turned.cosine < pack(0), pack(1), pack(0));
  const rotation<pack> sum = {pack(a.cos_light * a.cos_eye - a.sin_light * a.sin_eye),
                              pack(sine_of_sum(a.sin_light, a.cos_light, a.sin_eye, a.cos_eye))};
  const pack m =
      chiang_along(chiang_.longitudinal, sum, chiang_.tilts, tilted, flipped, pack(a.sin_light), pack(a.cos_light));
  const marschner_lobes<float> n = table_->lobes(a.sin_eye, a.phi);
  return m.lane[0] * n.reflected + m.lane[1] * n.transmitted + m.lane[2] * n.returned +
         m.lane[3] * table_->residual(a.sin_eye);
}

glm::vec3 fibre_bsdf::dual_share(const angles& a, const passage& passed, float opacity) const {
  if (!(passed.open > 0.0F)) return glm::vec3(0.0F);
  const float theta_i = angle_of_sine(a.sin_light);
  const float theta_r = angle_of_sine(a.sin_eye);
  const dual_averages<float> averages = look_up_dual_scattering<float>(averages_, theta_i);
  const dual_local<float> local = dual_local_scattering(averages, density);
  const float direct = passed.transmittance / passed.open;
  const dual_global<float> global = dual_global_scattering(averages, density, opacity * passed.fibres, direct);
  const glm::vec3 many = dual_scattering(averages, local, global, density, glm::vec3(0.0F), theta_i, theta_r, a.phi);
  // Shares of light, per steradian, become shares of radiance as Marschner's S does.
  const float sin_theta_d = sin_half_difference(theta_i, theta_r);
  const float cos2_theta_d = std::max((1.0F - sin_theta_d) * (1.0F + sin_theta_d), 1e-12F);
  return passed.transmittance * chiang_share(a) + (passed.open * a.cos_eye * a.cos_light / cos2_theta_d) * many;
}

glm::vec3 fibre_bsdf::scatter(const fibre_place& at, const glm::vec3& to_light, const passage& passed) const {
  if (look_.model == bsdf_model::kajiya_kay) return passed.transmittance * kajiya_kay_share(at, to_light);
  const angles a = angles_of(at.tangent, to_light, at.to_eye);
  if (look_.model == bsdf_model::dual_scattering) return pi * dual_share(a, passed, at.opacity);
  const glm::vec3 share = look_.model == bsdf_model::marschner ? marschner_share(a) : chiang_share(a);
  if (look_.passing == attenuation::fresnel) return pi * passed.transmittance * share;
  return pi * arriving(passed, table_->passage(a.sin_light)) * share;
}

glm::vec3 fibre_bsdf::reflect_sky(const fibre_place& at) const {
  if (look_.model == bsdf_model::kajiya_kay) return own_colour(at);
  const float sin_eye = held_sine(glm::dot(at.tangent, at.to_eye));
  if (look_.model != bsdf_model::dual_scattering) return 2.0F * table_->backward(sin_eye);
  const dual_averages<float> averages = look_up_dual_scattering<float>(averages_, angle_of_sine(sin_eye));
  // The lobe from behind is (1 - |φ|/π)/π round the fibre, of which the sky's own factor leaves 2/3.
  return 2.0F *
         (averages.backward + (4.0F / 3.0F * density.backward) * dual_local_scattering(averages, density).albedo);
}

namespace {

fibre_place place_of(const fibre_place_of<wide>& at, int k) {
  return {lane_of(at.tangent, k), lane_of(at.to_eye, k), lane_of(at.colour, k), at.opacity.lane[k]};
}

}  // namespace

wide3 fibre_bsdf::scatter(const fibre_place_of<wide>& at, const wide3& to_light, const passage_of<wide>& passed,
                          std::uint32_t set) const {
  if (look_.model == bsdf_model::kajiya_kay) return passed.transmittance * kajiya_kay_share(at, to_light);
  wide3_builder sent;
  for_each_lane(set, [&](int k) {
    const passage one{passed.transmittance.lane[k], passed.fibres.lane[k], passed.open.lane[k]};
    sent.set(k, scatter(place_of(at, k), lane_of(to_light, k), one));
  });
  return sent.done();
}

wide3 fibre_bsdf::reflect_sky(const fibre_place_of<wide>& at, std::uint32_t set) const {
  if (look_.model == bsdf_model::kajiya_kay) return own_colour(at);
  wide3_builder sent;
  for_each_lane(set, [&](int k) { sent.set(k, reflect_sky(place_of(at, k))); });
  return sent.done();
}

}  // namespace pelage::frame
