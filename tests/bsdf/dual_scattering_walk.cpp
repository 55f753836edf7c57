// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_sampling.hpp>
#include <pelage/bsdf/dual_scattering_table.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

using namespace pelage;

namespace {

/// Weights of light and the moments of half the change of its inclination, which is what θ_h is to the averages.
struct tally {
  double weight = 0.0;
  double shift = 0.0;
  double square = 0.0;
  void add(double light, double theta_h) {
    weight += light;
    shift += light * theta_h;
    square += light * theta_h * theta_h;
  }
  [[nodiscard]] double variance() const { return square / weight - (shift / weight) * (shift / weight); }
};

struct walked {
  std::array<tally, 4> passed;  ///< what the first 1 to 4 fibres pass on, none of them turning it back
  tally turned;                 ///< what the first fibre turns back
  tally from_behind;            ///< what comes back out of the fibres behind the first
};

/// Photons that walk through layers of parallel fibres, each layer one fibre to them, until they are in front of the
/// first again: Chiang's model at an even place across each fibre's width, every direction followed. Shares of light.
walked walk(const chiang_fibre<double>& fibre, double theta, int photons) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> draw(0.0, 1.0);
  walked sums;
  for (int k = 0; k < photons; ++k) {
    const double azimuth = std::numbers::pi * draw(generator);
    glm::dvec3 along(std::sin(theta), std::cos(theta) * std::cos(azimuth), std::cos(theta) * std::sin(azimuth));
    double weight = 1.0 / photons;
    bool straight = true;
    int layer = 0;
    for (std::size_t met = 1; layer >= 0 && weight > 1e-3 / photons; ++met) {
      const auto view = view_chiang(fibre, 2.0 * draw(generator) - 1.0, fibre_direction_of(-along));
      const auto drawn = sample_chiang(
          fibre, view, std::array<double, 4>{draw(generator), draw(generator), draw(generator), draw(generator)});
      weight *= drawn.result.value[0] / drawn.result.density;
      straight = straight && drawn.direction.z > 0.0;
      along = drawn.direction;
      layer += along.z > 0.0 ? 1 : -1;
      const double theta_h = 0.5 * (std::asin(along.x) - theta);
      if (straight && met <= sums.passed.size()) sums.passed[met - 1].add(weight, theta_h);
      if (layer < 0) (met == 1 ? sums.turned : sums.from_behind).add(weight, theta_h);
    }
  }
  return sums;
}

struct hair {
  double sigma;
  double theta;
  walked photons;
  dual_averages<double> averages;
};

/// Hair from light to dark, and light at right angles to it and aslant.
template <class Check>
void for_each_hair(Check check) {
  static const std::vector<hair> all = [] {
    std::vector<hair> made;
    for (const double sigma : {0.05, 0.2, 0.5}) {
      for (const double theta : {0.0, 0.5}) {
        const auto fibre = make_chiang_fibre<double>({1.55, {sigma, sigma, sigma}, 0.3, 0.3, 0.0});
        made.push_back({sigma, theta, walk(fibre, theta, 20000),
                        average_fibre(chiang_fibre_model<double>{fibre}, theta, 64U, 64U)});
      }
    }
    return made;
  }();
  for (const hair& one : all) {
    CAPTURE(one.sigma);
    CAPTURE(one.theta);
    check(one.photons, one.averages);
  }
}

constexpr dual_density<double> everywhere = {1.0, 1.0};

}  // namespace

TEST_CASE("photons that one fibre passes on or turns back are the averages' shares, with their spread") {
  for_each_hair([](const walked& photons, const dual_averages<double>& averages) {
    CHECK(photons.passed[0].weight == doctest::Approx(averages.forward.x).epsilon(0.02));
    CHECK(photons.passed[0].variance() == doctest::Approx(averages.forward_variance.x).epsilon(0.05));
    CHECK(photons.turned.weight == doctest::Approx(averages.backward.x).epsilon(0.04));
    CHECK(photons.turned.variance() == doctest::Approx(averages.backward_variance.x).epsilon(0.1));
  });
}

TEST_CASE("global scattering is a random walk's forward light within 10 % and its spread within 20 %, to 4 fibres") {
  for_each_hair([](const walked& photons, const dual_averages<double>& averages) {
    for (std::size_t n = 1; n <= photons.passed.size(); ++n) {
      CAPTURE(n);
      const auto global = dual_global_scattering(averages, everywhere, static_cast<double>(n), 0.0);
      CHECK(photons.passed[n - 1].weight == doctest::Approx(global.transmitted.x).epsilon(0.1));
      CHECK(photons.passed[n - 1].variance() == doctest::Approx(global.variance.x).epsilon(0.2));
    }
  });
}

TEST_CASE("local scattering is 1 to 1.3 times a random walk's light from behind, and up to half wider") {
  for_each_hair([](const walked& photons, const dual_averages<double>& averages) {
    const auto local = dual_local_scattering(averages, everywhere);
    const double light = local.albedo.x / photons.from_behind.weight;
    CHECK(light > 1.0);
    CHECK(light < 1.3);
    const double spread = dual_local_scattering(averages, {0.7, 0.7}).variance.x / photons.from_behind.variance();
    CHECK(spread > 1.0);
    CHECK(spread < 1.6);
  });
}
