// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/renderer_parameters.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

using namespace pelage;

namespace {

constexpr double pi = std::numbers::pi;
using lobes = std::array<double, 4>;

/// Chiang's model in angles, as the renderers' sources have it: each lobe's variance and grey tint, one scale of N, and
/// by how much the eye's or the light's inclination is turned before M.
struct published {
  double eta;
  double sigma_a;
  lobes tint;
  lobes variance;
  double scale;
  lobes eye_turn;
  lobes light_turn;

  [[nodiscard]] double operator()(double h, double theta_o, double theta_i, double phi) const {
    const double gamma_o = std::asin(h);
    const double eta_across = std::sqrt(eta * eta - std::pow(std::sin(theta_o), 2)) / std::cos(theta_o);
    const double gamma_t = std::asin(h / eta_across);
    const double cos_theta_t = std::sqrt(1.0 - std::pow(std::sin(theta_o) / eta, 2));
    const double kept = std::exp(-sigma_a * 2.0 * std::cos(gamma_t) / cos_theta_t);
    const double f = fresnel(std::cos(theta_o) * std::cos(gamma_o));
    const double through = (1.0 - f) * (1.0 - f) * kept;
    const lobes a = {f, through, through * f * kept, through * f * kept * f * kept / (1.0 - f * kept)};
    double sum = 0.0;
    for (std::size_t p = 0; p < 4; ++p) {
      const auto order = static_cast<double>(p);
      const double middle = 2.0 * order * gamma_t - 2.0 * gamma_o + order * pi;
      const double round = p == 3 ? 0.5 / pi : logistic(std::remainder(phi - middle, 2.0 * pi));
      sum += tint[p] * a[p] * round * along(theta_o + eye_turn[p], theta_i + light_turn[p], variance[p]);
    }
    return sum;
  }

  [[nodiscard]] double fresnel(double cosine) const {
    const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (eta * eta));
    const double across = (cosine - eta * inside) / (cosine + eta * inside);
    const double parallel = (eta * cosine - inside) / (eta * cosine + inside);
    return 0.5 * (across * across + parallel * parallel);
  }

  [[nodiscard]] static double along(double theta_o, double theta_i, double v) {
    return std::exp(-std::sin(theta_i) * std::sin(theta_o) / v) *
           std::cyl_bessel_i(0.0, std::abs(std::cos(theta_i) * std::cos(theta_o)) / v) / (2.0 * v * std::sinh(1.0 / v));
  }

  [[nodiscard]] double logistic(double x) const {
    const double e = std::exp(-std::abs(x) / scale);
    const double whole = 1.0 / (1.0 + std::exp(-pi / scale)) - 1.0 / (1.0 + std::exp(pi / scale));
    return e / (scale * (1.0 + e) * (1.0 + e)) / whole;
  }
};

double width_of(double beta) {
  return 0.726 * beta + 0.812 * beta * beta + 3.7 * std::pow(beta, 20.0);
}

double scale_of(double beta) {
  return 0.265 * beta + 1.194 * beta * beta + 5.372 * std::pow(beta, 22.0);
}

lobes chiang_variances(double v) {
  return {v, 0.25 * v, 4.0 * v, 4.0 * v};
}

double in(double low, double high) {
  return low + (high - low) * (*rc::gen::inRange(0, 10001) / 10000.0);
}

/// The fibre scatters as the renderer's formulas, at a drawn place and pair of directions within some inclination.
void scatters_as(const published& there, const chiang_fibre<double>& here, double steepest = 1.1,
                 double tolerance = 1e-5) {
  const double h = in(-0.95, 0.95);
  const double theta_o = in(-steepest, steepest);
  const double theta_i = in(-steepest, steepest);
  const double phi = in(-pi, pi);
  const auto view = view_chiang(here, h, fibre_direction_of(test::unit_vector<double>(theta_o, 0.4)));
  const auto light = fibre_direction_of(test::unit_vector<double>(theta_i, 0.4 + phi));
  const double expected = there(h, theta_o, theta_i, phi);
  const double found = evaluate_chiang(here, view, light).value[1];
  RC_ASSERT(std::abs(found - expected) <= tolerance * std::abs(expected) + 1e-12);
}

}  // namespace

TEST_CASE("a fibre of pbrt scatters as HairBxDF's formulas") {
  test::holds("pbrt", [] {
    const pbrt_hair<double> hair{in(1.2, 1.8), {9.0, in(0.0, 3.0), 9.0}, in(0.25, 0.9), in(0.1, 0.9), in(-8.0, 8.0)};
    const double a = hair.alpha * pi / 180.0;
    const double v = width_of(hair.beta_m) * width_of(hair.beta_m);
    scatters_as({hair.eta,
                 hair.sigma_a[1],
                 {1, 1, 1, 1},
                 chiang_variances(v),
                 std::sqrt(pi / 8.0) * scale_of(hair.beta_n),
                 {-2.0 * a, a, 4.0 * a, 0.0},
                 {}},
                make_chiang_fibre(chiang_from_pbrt(hair)));
  });
}

/// A drawn fibre of MaterialX and the formulas of chiang_hair_bsdf.
void scatters_as_materialx(double cuticle_angle, double tolerance) {
  materialx_hair<double> hair{
      {in(0.0, 2.0), in(0.0, 2.0), in(0.0, 2.0)}, in(1.2, 1.8), {}, cuticle_angle, {9.0, in(0.0, 3.0), 9.0}};
  hair.lobes = materialx_roughness(in(0.25, 0.9), in(0.1, 0.9), in(0.5, 1.5), in(0.5, 2.0));
  const auto variance = [&](std::size_t p) { return std::clamp(hair.lobes[p].variance, 0.001, 1.0); };
  const double a = hair.cuticle_angle * pi - 0.5 * pi;
  scatters_as({hair.ior,
               hair.absorption_coefficient[1],
               {hair.tints[0], hair.tints[1], hair.tints[2], hair.tints[2]},
               {variance(0), variance(1), variance(2), variance(2)},
               std::sqrt(pi / 8.0) * std::clamp(hair.lobes[0].scale, 0.001, 1.0),
               {},
               {2.0 * a, -a, -4.0 * a, 0.0}},
              chiang_from_materialx(hair), pi / 4.0, tolerance);
}

TEST_CASE("a fibre of MaterialX scatters as chiang_hair_bsdf's formulas, whose tilt turns the light") {
  test::holds("no tilt", [] { scatters_as_materialx(0.5, 1e-5); });
  test::holds("2 degrees either way", [] { scatters_as_materialx(0.5 + in(-2.0, 2.0) / 180.0, 0.15); });
}

TEST_CASE("a strand of Cycles scatters as principled hair's formulas") {
  test::holds("Cycles", [] {
    const cycles_hair<double> hair{{9.0, in(0.0, 3.0), 9.0},
                                   in(0.3, 0.8),
                                   in(0.2, 0.8),
                                   in(0.0, 0.3),
                                   in(1.2, 1.8),
                                   in(-0.1, 0.1),
                                   in(0.0, 1.0),
                                   in(0.0, 0.2)};
    const double factor = 1.0 + 2.0 * (hair.random - 0.5) * hair.random_roughness;
    const double rough = std::min(hair.roughness * factor, 1.0);
    lobes variance = chiang_variances(width_of(rough) * width_of(rough));
    variance[0] = std::pow(width_of((1.0 - hair.coat) * rough), 2.0);
    const double a = -hair.offset;
    scatters_as({hair.ior,
                 hair.absorption[1],
                 {1, 1, 1, 1},
                 variance,
                 std::sqrt(pi / 8.0) * scale_of(std::min(hair.radial_roughness * factor, 1.0)),
                 {-2.0 * a, a, 4.0 * a, 0.0},
                 {}},
                chiang_from_cycles(hair));
  });
}

TEST_CASE("the helpers have the published values") {
  const auto lobe = materialx_roughness(0.1, 0.2, 0.5, 2.0);
  CHECK(lobe[0].variance == doctest::Approx(0.0065157184).epsilon(1e-6));
  CHECK(lobe[1].variance == doctest::Approx(0.0016289296).epsilon(1e-6));
  CHECK(lobe[2].variance == doctest::Approx(0.0260628736).epsilon(1e-6));
  CHECK(lobe[2].scale == doctest::Approx(0.10076).epsilon(1e-6));
  CHECK(materialx_roughness(-1.0, 7.0, 1.0, 1.0)[0].variance == doctest::Approx(std::pow(width_of(0.001), 2)));
  CHECK(materialx_roughness(-1.0, 7.0, 1.0, 1.0)[0].scale == doctest::Approx(6.831));

  const auto brown = materialx_absorption_from_melanin(0.25, 0.5);
  const double amount = 0.287682072451781;
  const std::array<double, 3> eumelanin = {0.657704, 0.498077, 0.254107};
  const std::array<double, 3> pheomelanin = {0.829444, 0.670320, 0.349938};
  for (std::size_t c = 0; c < 3; ++c) {
    const double expected = -0.5 * amount * (std::log(eumelanin[c]) + std::log(pheomelanin[c]));
    CHECK(brown[c] == doctest::Approx(expected).epsilon(1e-5));
  }
  CHECK(materialx_absorption_from_melanin(1.0, 0.0)[0] == doctest::Approx(0.419 * 9.210340371976182));
  CHECK(materialx_absorption_from_colour(0.0, 0.2) ==
        doctest::Approx(std::pow(std::log(0.001) / 5.9504368, 2)).epsilon(1e-6));

  const auto black = cycles_absorption_from_melanin(1.0, 0.0, 0.5, 0.0);
  CHECK(black[0] == doctest::Approx(0.506 * 9.210340371976182));
  const auto red = cycles_absorption_from_melanin(0.5, 1.0, 0.5, 1.0);
  CHECK(red[2] == doctest::Approx(1.924 * 0.693147180559945));
  const auto varied = cycles_absorption_from_melanin(0.5, 0.0, 1.0, 0.5);  // melanin 0.75
  CHECK(varied[1] == doctest::Approx(0.841 * 1.386294361119891));
  CHECK(cycles_absorption_from_colour(1.0, 0.3) == 0.0);
}

TEST_CASE("parameters go there and back") {
  test::holds("round trips", [] {
    const chiang_parameters<double> fibre{
        in(1.2, 1.8), {in(0.0, 9.0), 1.0, 2.0}, in(0.3, 0.45), in(0.1, 0.6), in(-0.1, 0.1)};
    const auto again = chiang_from_pbrt(pbrt_from_chiang(fibre));
    RC_ASSERT(std::abs(again.tilt - fibre.tilt) < 1e-15);
    RC_ASSERT(again.beta_m == fibre.beta_m && again.eta == fibre.eta);
    const auto own = make_chiang_fibre(fibre);
    for (const auto& other :
         {chiang_from_materialx(materialx_from_chiang(fibre)), chiang_from_cycles(cycles_from_chiang(fibre))}) {
      for (std::size_t p = 0; p < 4; ++p) {
        RC_ASSERT(std::abs(other.longitudinal[p].variance / own.longitudinal[p].variance - 1.0) < 1e-6);
        RC_ASSERT(other.tints[p] == 1.0);
      }
      RC_ASSERT(std::abs(other.azimuthal.scale / own.azimuthal.scale - 1.0) < 1e-6);
      RC_ASSERT(std::abs(other.tilts[1].sine - own.tilts[1].sine) < 1e-12);
      RC_ASSERT(other.sigma_a == own.sigma_a);
    }
  });
}
