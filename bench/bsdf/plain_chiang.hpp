// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace pelage::bench {

/// Chiang's model as one writes it down from the paper: angles, standard functions, one lobe after another, in float.
/// What the library is measured against, in the same run; nothing here is part of it.
///
/// Its log I₀ is the usual one, ten terms of the series up to an argument of 12, an asymptotic form beyond, so it is
/// less accurate than the library is; its speed is what it is here for.
class plain_chiang {
 public:
  plain_chiang(float h, float eta, glm::vec3 sigma_a, float beta_m, float beta_n, float tilt)
      : h_(h), gamma_o_(std::asin(std::clamp(h, -1.0f, 1.0f))), eta_(eta), sigma_a_(sigma_a) {
    const float width = 0.726f * beta_m + 0.812f * beta_m * beta_m + 3.7f * std::pow(beta_m, 20.0f);
    variance_[0] = width * width;
    variance_[1] = 0.25f * variance_[0];
    variance_[2] = 4.0f * variance_[0];
    variance_[3] = variance_[2];
    scale_ = 0.626657069f * (0.265f * beta_n + 1.194f * beta_n * beta_n + 5.372f * std::pow(beta_n, 22.0f));
    sin_tilt_[0] = std::sin(tilt);
    cos_tilt_[0] = std::sqrt(1.0f - sin_tilt_[0] * sin_tilt_[0]);
    for (std::size_t k = 1; k < 3; ++k) {
      sin_tilt_[k] = 2.0f * cos_tilt_[k - 1] * sin_tilt_[k - 1];
      cos_tilt_[k] = cos_tilt_[k - 1] * cos_tilt_[k - 1] - sin_tilt_[k - 1] * sin_tilt_[k - 1];
    }
  }

  [[nodiscard]] glm::vec3 f(const glm::vec3& wo, const glm::vec3& wi) const {
    const angles o = take_apart(wo);
    const angles i = take_apart(wi);
    const float gamma_t = refracted(o);
    const std::array<glm::vec3, 4> a = attenuation(o, gamma_t);
    glm::vec3 sum(0.0f);
    for (std::size_t p = 0; p < 3; ++p) {
      sum += along(p, o, i) * round(i.phi - o.phi, p, gamma_t) * a[p];
    }
    sum += along(3, o, i) * a[3] / (2.0f * pi);
    return std::abs(wi.z) > 0.0f ? sum / std::abs(wi.z) : sum;
  }

  [[nodiscard]] float pdf(const glm::vec3& wo, const glm::vec3& wi) const {
    const angles o = take_apart(wo);
    const angles i = take_apart(wi);
    const float gamma_t = refracted(o);
    const std::array<float, 4> w = weights(attenuation(o, gamma_t));
    float sum = 0.0f;
    for (std::size_t p = 0; p < 3; ++p) {
      sum += along(p, o, i) * round(i.phi - o.phi, p, gamma_t) * w[p];
    }
    return sum + along(3, o, i) * w[3] / (2.0f * pi);
  }

  [[nodiscard]] glm::vec3 sample(const glm::vec3& wo, glm::vec4 u) const {
    const angles o = take_apart(wo);
    const float gamma_t = refracted(o);
    const std::array<float, 4> w = weights(attenuation(o, gamma_t));
    std::size_t p = 0;
    while (p < 3 && u[0] >= w[p]) {
      u[0] -= w[p];
      ++p;
    }
    float sin_o = o.sin_theta;
    float cos_o = o.cos_theta;
    tilted(p, sin_o, cos_o);
    const float v = variance_[p];
    const float cos_theta = 1.0f + v * std::log(std::max(u[1], 1e-5f) + (1.0f - u[1]) * std::exp(-2.0f / v));
    const float sin_theta = std::sqrt(std::max(0.0f, 1.0f - cos_theta * cos_theta));
    const float sin_i = std::clamp(-cos_theta * sin_o + sin_theta * std::cos(2.0f * pi * u[2]) * cos_o, -1.0f, 1.0f);
    const float cos_i = std::sqrt(1.0f - sin_i * sin_i);
    float phi = 2.0f * pi * u[3];
    if (p < 3) {
      const float low = 1.0f / (1.0f + std::exp(pi / scale_));
      const float x = -scale_ * std::log(1.0f / (u[3] * (1.0f - 2.0f * low) + low) - 1.0f);
      phi = middle(p, gamma_t) + std::clamp(x, -pi, pi);
    }
    phi += o.phi;
    return {sin_i, cos_i * std::cos(phi), cos_i * std::sin(phi)};
  }

 private:
  static constexpr float pi = std::numbers::pi_v<float>;

  struct angles {
    float sin_theta, cos_theta, phi;
  };

  static angles take_apart(const glm::vec3& w) {
    return {w.x, std::sqrt(std::max(0.0f, 1.0f - w.x * w.x)), std::atan2(w.z, w.y)};
  }

  float refracted(const angles& o) const {
    const float bravais = std::sqrt(eta_ * eta_ - o.sin_theta * o.sin_theta) / o.cos_theta;
    return std::asin(std::clamp(h_ / bravais, -1.0f, 1.0f));
  }

  static float fresnel(float cosine, float eta) {
    const float sin_t = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)) / eta;
    const float cos_t = std::sqrt(std::max(0.0f, 1.0f - sin_t * sin_t));
    const float parallel = (eta * cosine - cos_t) / (eta * cosine + cos_t);
    const float perpendicular = (cosine - eta * cos_t) / (cosine + eta * cos_t);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
  }

  std::array<glm::vec3, 4> attenuation(const angles& o, float gamma_t) const {
    const float sin_t = o.sin_theta / eta_;
    const float cos_t = std::sqrt(1.0f - sin_t * sin_t);
    const float length = 2.0f * std::cos(gamma_t) / cos_t;
    const glm::vec3 t(std::exp(-sigma_a_.x * length), std::exp(-sigma_a_.y * length), std::exp(-sigma_a_.z * length));
    const float f = fresnel(o.cos_theta * std::sqrt(std::max(0.0f, 1.0f - h_ * h_)), eta_);
    const glm::vec3 once = (1.0f - f) * (1.0f - f) * t;
    const glm::vec3 twice = once * t * f;
    return {glm::vec3(f), once, twice, twice * f * t / (1.0f - t * f)};
  }

  static std::array<float, 4> weights(const std::array<glm::vec3, 4>& a) {
    std::array<float, 4> w{};
    float sum = 0.0f;
    for (std::size_t p = 0; p < 4; ++p) {
      w[p] = (a[p].x + a[p].y + a[p].z) / 3.0f;
      sum += w[p];
    }
    for (float& each : w) {
      each /= sum;
    }
    return w;
  }

  static float bessel_i0(float x) {
    float sum = 0.0f;
    float power = 1.0f;
    float factorial = 1.0f;
    float fours = 1.0f;
    for (int k = 0; k < 10; ++k) {
      if (k > 1) {
        factorial *= static_cast<float>(k);
      }
      sum += power / (fours * factorial * factorial);
      power *= x * x;
      fours *= 4.0f;
    }
    return sum;
  }

  static float log_bessel_i0(float x) {
    if (x > 12.0f) {
      return x + 0.5f * (std::log(1.0f / (2.0f * pi * x)) + 0.25f / x);
    }
    return std::log(bessel_i0(x));
  }

  void tilted(std::size_t p, float& sin_o, float& cos_o) const {
    const float s = sin_o;
    const float c = cos_o;
    if (p == 0) {
      sin_o = s * cos_tilt_[1] - c * sin_tilt_[1];
      cos_o = c * cos_tilt_[1] + s * sin_tilt_[1];
    } else if (p < 3) {
      const std::size_t k = p == 1 ? 0 : 2;
      sin_o = s * cos_tilt_[k] + c * sin_tilt_[k];
      cos_o = c * cos_tilt_[k] - s * sin_tilt_[k];
    }
    cos_o = std::abs(cos_o);
  }

  float along(std::size_t p, const angles& o, const angles& i) const {
    float sin_o = o.sin_theta;
    float cos_o = o.cos_theta;
    tilted(p, sin_o, cos_o);
    const float v = variance_[p];
    const float a = i.cos_theta * cos_o / v;
    const float b = i.sin_theta * sin_o / v;
    if (v <= 0.1f) {
      return std::exp(log_bessel_i0(a) - b - 1.0f / v + 0.6931f + std::log(1.0f / (2.0f * v)));
    }
    return std::exp(-b) * bessel_i0(a) / (std::sinh(1.0f / v) * 2.0f * v);
  }

  float middle(std::size_t p, float gamma_t) const {
    return 2.0f * static_cast<float>(p) * gamma_t - 2.0f * gamma_o_ + static_cast<float>(p) * pi;
  }

  float logistic(float x) const {
    const float e = std::exp(-std::abs(x) / scale_);
    return e / (scale_ * (1.0f + e) * (1.0f + e));
  }

  float round(float phi, std::size_t p, float gamma_t) const {
    float x = phi - middle(p, gamma_t);
    while (x > pi) {
      x -= 2.0f * pi;
    }
    while (x < -pi) {
      x += 2.0f * pi;
    }
    const float below = 1.0f / (1.0f + std::exp(pi / scale_));
    const float above = 1.0f / (1.0f + std::exp(-pi / scale_));
    return logistic(x) / (above - below);
  }

  float h_, gamma_o_, eta_;
  glm::vec3 sigma_a_;
  std::array<float, 4> variance_{};
  float scale_ = 0.0f;
  std::array<float, 3> sin_tilt_{}, cos_tilt_{};
};

}  // namespace pelage::bench
