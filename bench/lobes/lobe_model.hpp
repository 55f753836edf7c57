// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang_far_field.hpp>
#include <pelage/bsdf/kajiya_kay_highlights.hpp>
#include <pelage/bsdf/marschner.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace pelage::bench {

/// What an artist sets.
struct lobe_settings {
  std::string model = "chiang";
  std::array<double, 3> sigma_a = {0.06, 0.1, 0.2};
  double eta = 1.55;
  double beta_m = 0.3;
  double beta_n = 0.3;
  double tilt = 0.035;   ///< of the cuticle's scales towards the tip, radians; turns R to the root
  double theta_i = 0.0;  ///< inclination of the light, radians
};

/// The share of light that each lobe of a fibre sends from θ_i to (θ_r, φ), per steradian, for red, green and blue.
/// φ is 0 back to the light.
class lobe_model {
 public:
  explicit lobe_model(const lobe_settings& settings)
      : settings_(settings),
        fibre_(make_chiang_fibre<double>(
            {settings.eta, settings.sigma_a, settings.beta_m, settings.beta_n, -settings.tilt})),
        marschner_(common_marschner_parameters(settings.sigma_a)) {
    marschner_.eta = settings.eta;
    marschner_.beta = 0.5 * std::sqrt(longitudinal_variance(settings.beta_m));  // θ_h is half of θ_i + θ_r
    marschner_.alpha = -settings.tilt;
    if (settings.model == "chiang") {
      names_ = {"R", "TT", "TRT", "residual"};
    } else if (settings.model == "marschner") {
      names_ = {"R", "TT", "TRT"};
    } else {
      names_ = {"diffuse", "primary", "secondary"};
    }
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  [[nodiscard]] std::vector<glm::dvec3> operator()(double theta_r, double phi) const {
    if (settings_.model == "chiang") {
      return chiang(theta_r, phi);
    }
    return settings_.model == "marschner" ? marschner(theta_r, phi) : kajiya_kay(theta_r, phi);
  }

  [[nodiscard]] bool has_near_field() const { return settings_.model == "chiang"; }

  /// What the far field stands for: Chiang's model without M at 2,000 places of the width, averaged; grey, per radian.
  [[nodiscard]] double near_field_averaged(double phi) const {
    constexpr int places = 2000;
    const fibre_direction<double> from = {std::sin(settings_.theta_i), std::cos(settings_.theta_i), 1.0, 0.0};
    double sum = 0.0;
    for (int k = 0; k < places; ++k) {
      const rotation<double> offset = rotation_by(((k + 0.5) / places - 0.5) * std::numbers::pi);
      const auto view = view_chiang(fibre_, offset.sine, from);
      for (std::size_t p = 0; p < 4; ++p) {
        const double n = p == 3 ? 0.5 / std::numbers::pi
                                : chiang_round(fibre_.azimuthal, view.towards[p], std::cos(phi), std::sin(phi));
        const std::array<double, 3>& a = view.attenuation[p];
        sum += 0.5 * offset.cosine * std::numbers::pi / places * n * (a[0] + a[1] + a[2]) / 3.0;
      }
    }
    return sum;
  }

 private:
  [[nodiscard]] std::vector<glm::dvec3> chiang(double theta_r, double phi) const {
    const fibre_direction<double> from = {std::sin(settings_.theta_i), std::cos(settings_.theta_i), 1.0, 0.0};
    const fibre_direction<double> to = {std::sin(theta_r), std::cos(theta_r), std::cos(phi), std::sin(phi)};
    const std::array<double, 4> along = chiang_inclinations(fibre_, view_chiang(fibre_, 0.0, from), to);
    const auto averages = chiang_far_lobes(fibre_, from.sine, from.cosine, rotation<double>{to.y, to.z}).value;
    std::vector<glm::dvec3> lobes;
    for (std::size_t p = 0; p < 4; ++p) {
      const std::array<double, 3>& n = averages[p];
      lobes.push_back(along[p] * glm::dvec3(n[0], n[1], n[2]));
    }
    return lobes;
  }

  [[nodiscard]] std::vector<glm::dvec3> marschner(double theta_r, double phi) const {
    const marschner_result<double> result = evaluate_marschner(marschner_, settings_.theta_i, theta_r, phi, 0.0);
    const double cosine = std::cos(0.5 * (theta_r - settings_.theta_i));
    std::vector<glm::dvec3> lobes;
    for (std::size_t p = 0; p < 3; ++p) {
      lobes.push_back(0.5 * std::cos(theta_r) * result.longitudinal[p] / (cosine * cosine) * result.azimuthal[p]);
    }
    return lobes;
  }

  /// The diffuse lobe of a mass's albedo, a white highlight of a twentieth and a coloured one of a quarter of the
  /// light.
  [[nodiscard]] std::vector<glm::dvec3> kajiya_kay(double theta_r, double phi) const {
    glm::dvec3 colour;
    for (int c = 0; c < 3; ++c) {
      colour[c] = albedo_from_absorption(settings_.sigma_a[static_cast<std::size_t>(c)], settings_.beta_n);
    }
    const auto direction = [](double theta, double azimuth) {
      return glm::vec3(
          glm::dvec3(std::sin(theta), std::cos(theta) * std::cos(azimuth), std::cos(theta) * std::sin(azimuth)));
    };
    // An exponent whose lobe in θ has the width that β_m stands for, and half of it for the secondary's double width.
    const double variance = longitudinal_variance(settings_.beta_m);
    const highlight_shape primary = {static_cast<float>(1.0 / variance), static_cast<float>(-2.0 * settings_.tilt)};
    const highlight_shape secondary = {static_cast<float>(0.25 / variance), static_cast<float>(4.0 * settings_.tilt)};
    const double_highlight both = kajiya_kay_double(glm::vec3(1.0f, 0.0f, 0.0f), direction(settings_.theta_i, 0.0),
                                                    direction(theta_r, phi), primary, secondary);
    const double cosine = std::cos(theta_r);
    const double height = 1.0 / (6.2832 * std::sqrt(6.2832 * variance));
    return {glm::dvec3(normalised_fibre_diffuse(1.0f)) * colour * cosine,
            glm::dvec3(0.05 * height * static_cast<double>(both.primary)),
            0.25 * 0.5 * height * static_cast<double>(both.secondary) * colour};
  }

  lobe_settings settings_;
  chiang_fibre<double> fibre_;
  marschner_parameters<double> marschner_;
  std::vector<std::string> names_;
};

}  // namespace pelage::bench
