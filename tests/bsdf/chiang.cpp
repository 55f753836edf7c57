// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_quad.hpp>
#include <pelage/bsdf/chiang_sampling.hpp>
#include <pelage/bsdf/fresnel.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>
#include <sweep.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace pelage;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

chiang_fibre<float> clear_fibre(double beta_m, double beta_n, double tilt) {
  return make_chiang_fibre<float>(
      {1.55f, {0.0f, 0.0f, 0.0f}, static_cast<float>(beta_m), static_cast<float>(beta_n), static_cast<float>(tilt)});
}

/// The light that leaves in all directions and the integral of the density, by way of the form in four lanes, which
/// has the kernel's bits.
std::array<double, 2> furnace(const chiang_fibre<float>& fibre, double h, double theta_o) {
  const chiang_quad_fibre quad = make_chiang_quad_fibre(fibre);
  const auto view =
      view_chiang(quad, static_cast<float>(h), fibre_direction_of(test::unit_vector<float>(theta_o, 0.4)));
  const int thetas = test::theta_panels_for(fibre);
  const int phis = test::phi_count_for(fibre);
  return {test::integrate_sphere<float>(
              thetas, phis,
              [&](const glm::vec3& light) { return evaluate_chiang(quad, view, fibre_direction_of(light)).value[1]; }),
          test::integrate_sphere<float>(thetas, phis, [&](const glm::vec3& light) {
            return chiang_density(quad, view, fibre_direction_of(light));
          })};
}

}  // namespace

TEST_CASE("white furnace: a clear fibre sends out all light, within 2e-4 in float") {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> draw(0.0, 1.0);
  double least = 2.0;
  double greatest = 0.0;
  double least_density = 2.0;
  double greatest_density = 0.0;
  const auto check = [&](double beta_m, double beta_n, double tilt, double theta, double h) {
    const std::array<double, 2> sums = furnace(clear_fibre(beta_m, beta_n, tilt * degree), h, theta * degree);
    least = std::min(least, sums[0]);
    greatest = std::max(greatest, sums[0]);
    least_density = std::min(least_density, sums[1]);
    greatest_density = std::max(greatest_density, sums[1]);
    CAPTURE(beta_m);
    CAPTURE(beta_n);
    CAPTURE(tilt);
    CAPTURE(theta);
    CAPTURE(h);
    CHECK(std::abs(sums[0] - 1.0) < 2e-4);
    CHECK(std::abs(sums[1] - 1.0) < 1e-3);
  };
  check(0.05, 0.05, 10.0, 85.0, 0.5);
  check(0.05, 1.0, -10.0, -85.0, 1.0);
  check(1.0, 0.05, 10.0, -85.0, -1.0);
  check(1.0, 1.0, -10.0, 85.0, 0.999);
  check(0.3, 0.3, 0.0, 0.0, 0.0);
  for (int k = 0; k < 25; ++k) {
    const double beta_m = 0.05 + 0.95 * draw(generator);
    const double beta_n = 0.05 + 0.95 * draw(generator);
    check(beta_m, beta_n, 20.0 * draw(generator) - 10.0, 170.0 * draw(generator) - 85.0, 2.0 * draw(generator) - 1.0);
  }
  MESSAGE("furnace in [", least, ", ", greatest, "], density in [", least_density, ", ", greatest_density, "]");
}

TEST_CASE("with absorption less light leaves, in each channel as if it were alone") {
  const auto fibre = make_chiang_fibre<float>({1.55f, {0.1f, 0.5f, 2.0f}, 0.3f, 0.3f, 0.03f});
  const auto view = view_chiang(fibre, 0.3f, fibre_direction_of(test::unit_vector<float>(0.4, 0.0)));
  for (std::uint32_t c = 0; c < 3; ++c) {
    double expected = 0.0;
    for (std::uint32_t p = 0; p < 4; ++p) {
      expected += static_cast<double>(view.attenuation[p][c]);
    }
    const double sum = test::integrate_sphere<float>(60, 150, [&](const glm::vec3& light) {
      return evaluate_chiang(fibre, view, fibre_direction_of(light)).value[static_cast<int>(c)];
    });
    CHECK(sum == doctest::Approx(expected).epsilon(1e-4));
    CHECK(sum < 1.0002);
  }
}

TEST_CASE("energy never exceeds 1, whatever the fibre") {
  test::holds("Σ A_p ≤ 1 for any index, absorption, offset and inclination", [](std::uint16_t eta, std::uint16_t sigma,
                                                                                std::int16_t h, std::int16_t theta) {
    const auto fibre =
        make_chiang_fibre<float>({1.0f + eta / 40000.0f, {sigma / 10000.0f, 0.0f, 100.0f}, 0.3f, 0.3f, 0.0f});
    const auto view =
        view_chiang(fibre, h / 32767.0f, fibre_direction_of(test::unit_vector<float>(theta / 32768.0 * 1.5707, 0)));
    for (std::uint32_t c = 0; c < 3; ++c) {
      float sum = 0.0f;
      for (std::uint32_t p = 0; p < 4; ++p) {
        RC_ASSERT(view.attenuation[p][c] >= 0.0f);
        sum += view.attenuation[p][c];
      }
      RC_ASSERT(sum < 1.000002f);
      RC_ASSERT(c != 1 || sum > 0.999998f);  // σ_a = 0
    }
  });
}

TEST_CASE("R is reciprocal without tilt: both directions at one inclination or swapped see one reflectance") {
  // R's F depends on cos θ_o √(1 - h²), so swapping needs |θ| equal; M R is symmetric for any pair.
  const auto fibre = make_chiang_fibre<double>({1.55, {1e30, 1e30, 1e30}, 0.25, 0.3, 0.0});
  for (const double theta : {0.1, 0.5, 1.1}) {
    for (const double phi : {0.3, 1.0, 2.5}) {
      const double h = 0.35;
      const glm::dvec3 one = test::unit_vector<double>(theta, 0.7);
      const glm::dvec3 other = test::unit_vector<double>(-theta, 0.7 + phi);
      const auto forth =
          evaluate_chiang(fibre, view_chiang(fibre, h, fibre_direction_of(one)), fibre_direction_of(other));
      // Seen from the other side the mirror's normal is at the same place, on the other half of the width.
      const auto back =
          evaluate_chiang(fibre, view_chiang(fibre, -h, fibre_direction_of(other)), fibre_direction_of(one));
      CHECK(forth.value[0] > 0.0);
      CHECK(back.value[0] == doctest::Approx(forth.value[0]).epsilon(1e-12));
    }
  }
}

TEST_CASE("mirrored fibres scatter alike") {
  test::holds("h and both azimuths negated change nothing", [](std::int8_t h, std::int8_t a, std::int8_t b) {
    const auto fibre = make_chiang_fibre<double>({1.5, {0.1, 0.2, 0.3}, 0.3, 0.2, 0.05});
    const auto value = [&](double sign) {
      return evaluate_chiang_bsdf(fibre, sign * h / 128.0, test::unit_vector<double>(a / 100.0, sign * 0.3),
                                  test::unit_vector<double>(b / 100.0, sign * 1.2));
    };
    RC_ASSERT(std::abs(value(1.0).density - value(-1.0).density) <= 1e-12 * value(1.0).density);
  });
}

TEST_CASE("fibres turned end for end scatter alike with the tilt negated") {
  const auto with = make_chiang_fibre<double>({1.5, {0.1, 0.2, 0.3}, 0.3, 0.2, 0.05});
  const auto against = make_chiang_fibre<double>({1.5, {0.1, 0.2, 0.3}, 0.3, 0.2, -0.05});
  for (const double theta : {-1.2, -0.3, 0.0, 0.6, 1.5}) {
    const auto one =
        evaluate_chiang_bsdf(with, 0.4, test::unit_vector<double>(theta, 0.3), test::unit_vector<double>(0.2, 1.5));
    const auto other = evaluate_chiang_bsdf(against, 0.4, test::unit_vector<double>(-theta, 0.3),
                                            test::unit_vector<double>(-0.2, 1.5));
    CHECK(one.f.x == doctest::Approx(other.f.x).epsilon(1e-12));
  }
}

TEST_CASE("every unit vector, roughness and offset gives a finite result") {
  const std::array<float, 7> offsets = {-1.0f, -0.9999999f, 0.0f, 0.5f, 1.0f, 3.0f, -7.0f};
  const std::array<float, 5> roughnesses = {0.0f, 1e-6f, 0.03f, 0.5f, 1.0f};
  const std::array<float, 4> sigmas = {0.0f, 0.7f, 1e20f, std::numeric_limits<float>::infinity()};
  const std::array<glm::vec3, 7> directions = {glm::vec3(1, 0, 0),          glm::vec3(-1, 0, 0),
                                               glm::vec3(0, 1, 0),          glm::vec3(0, 0, -1),
                                               glm::vec3(0.6f, 0.8f, 0.0f), glm::vec3(0.99999994f, 0.0f, 3.4e-4f),
                                               glm::vec3(-0.6f, 0.0f, 0.8f)};
  int finite = 0;
  int count = 0;
  for (const float h : offsets) {
    for (const float rough : roughnesses) {
      for (const float sigma : sigmas) {
        for (const float eta : {1.0f, 1.55f}) {
          const auto fibre = make_chiang_fibre<float>({eta, {sigma, 0.0f, 1.0f}, rough, rough, 0.1f});
          for (const glm::vec3& eye : directions) {
            for (const glm::vec3& light : directions) {
              const auto result = evaluate_chiang_bsdf(fibre, h, eye, light);
              const float sum = result.f.x + result.f.y + result.f.z + result.density;
              ++count;
              finite += std::isfinite(sum) && sum >= 0.0f ? 1 : 0;
            }
          }
        }
      }
    }
  }
  CHECK(finite == count);
}

TEST_CASE("the BSDF times the cosine that it was divided by is the kernel's value") {
  const auto fibre = make_chiang_fibre<double>({1.55, {0.2, 0.4, 0.9}, 0.3, 0.3, 0.03});
  const glm::dvec3 eye = test::unit_vector<double>(0.3, 0.2);
  const glm::dvec3 light = test::unit_vector<double>(-0.2, 1.0);
  const auto view = view_chiang(fibre, 0.2, fibre_direction_of(eye));
  const auto value = evaluate_chiang(fibre, view, fibre_direction_of(light));
  const auto bsdf = evaluate_chiang_bsdf(fibre, 0.2, eye, light);
  CHECK(bsdf.f.y * std::abs(light.z) == doctest::Approx(value.value[1]).epsilon(1e-14));
  CHECK(bsdf.density == value.density);
  CHECK(chiang_density(fibre, view, fibre_direction_of(light)) == doctest::Approx(value.density).epsilon(1e-15));
  const auto level = evaluate_chiang_bsdf(fibre, 0.2, eye, glm::dvec3(0.0, 1.0, 0.0));
  CHECK(level.f.x == evaluate_chiang(fibre, view, fibre_direction_of(glm::dvec3(0.0, 1.0, 0.0))).value[0]);
}

TEST_CASE("the lobes' weights sum to 1 within 3e-7 for any fibre and view, or are all 0 where nothing leaves") {
  test::worst_case worst;
  int black = 0;
  for (int i = 0; i < 60000; ++i) {
    const auto p = test::even_point<6>(i);
    const double eta = i % 7 == 0 ? 1.0 : i % 5 == 0 ? 1.0 + test::on_log_scale(p[0], 1e-7, 1.0) : 1.0 + 2.0 * p[0];
    const auto sigma = [&](double u,
                           int kind) {  // none, from denormal to huge, about where the last light goes, common
      const std::array<double, 4> all{0.0, test::on_log_scale(u, 1e-45, 1e30), test::on_log_scale(u, 1.0, 200.0),
                                      10.0 * u};
      return static_cast<float>(all[static_cast<std::size_t>(kind % 4)]);
    };
    const float h = i % 11 == 0 ? 1.0f : i % 11 == 1 ? -1.0f : static_cast<float>(2.0 * p[4] - 1.0);
    const float x = i % 13 == 0 ? 1.0f : i % 13 == 1 ? -1.0f : static_cast<float>(2.0 * p[5] - 1.0);
    const auto fibre = make_chiang_fibre<float>(
        {static_cast<float>(eta), {sigma(p[1], i), sigma(p[2], i / 4), sigma(p[3], i / 16)}, 0.3f, 0.3f, 0.0f});
    const auto weights = view_chiang(fibre, h, fibre_direction_of(x, std::sqrt((1.0f - x) * (1.0f + x)), 0.0f)).weights;
    double sum = 0.0;
    for (const float weight : weights) {
      REQUIRE((weight >= 0.0f && weight <= 1.000001f));
      sum += weight;
    }
    black += sum == 0.0 ? 1 : 0;
    if (sum != 0.0)
      worst.see(std::abs(sum - 1.0), {eta, h, x, sigma(p[1], i), sigma(p[2], i / 4), sigma(p[3], i / 16)});
  }
  CHECK_MESSAGE(worst.error < 3e-7, worst);
  CHECK(black > 0);
}

TEST_CASE("tints scale their lobe alone") {
  auto fibre = make_chiang_fibre<double>({1.55, {0.2, 0.4, 0.9}, 0.3, 0.3, 0.03});
  fibre.tints = {0.0, 1.0, 0.0, 0.0};
  const auto eye = fibre_direction_of(test::unit_vector<double>(0.3, 0.2));
  const auto view = view_chiang(fibre, 0.2, eye);
  CHECK(view.weights[1] == doctest::Approx(1.0).epsilon(1e-15));
  const auto light = fibre_direction_of(test::unit_vector<double>(-0.3, 3.1));
  CHECK(evaluate_chiang(fibre, view, light).value[0] ==
        doctest::Approx(chiang_lobes(fibre, view, light)[1] * view.attenuation[1][0]).epsilon(1e-15));
}

namespace {

/// One draw: a fibre and a pair of directions.
struct drawn_pair {
  // η, σ_a, β_m, β_n, tilt, h; then sin θ and azimuth of the eye and of the light.
  std::array<float, 10> number;

  [[nodiscard]] bool in_range(float least_eta, float most_eta, float least_roughness) const {
    const auto& n = number;
    const auto within = [](float x, float low, float high) { return x >= low && x <= high; };
    return within(n[0], least_eta, most_eta) && within(n[1], 0.0f, 10.0f) && within(n[2], least_roughness, 1.0f) &&
           within(n[3], least_roughness, 1.0f) && within(n[4], -0.17f, 0.17f) && within(n[5], -1.0f, 1.0f) &&
           within(n[6], -1.0f, 1.0f) && within(n[8], -1.0f, 1.0f);
  }

  template <class Real>
  [[nodiscard]] chiang_result<Real> evaluated() const {
    const auto& n = number;
    const auto direction = [](float x, float azimuth) {
      const float across = std::sqrt((1.0f - x) * (1.0f + x));
      return fibre_direction_of(Real(x), Real(across * std::cos(azimuth)), Real(across * std::sin(azimuth)));
    };
    const auto fibre =
        make_chiang_fibre<Real>({Real(n[0]), {Real(n[1]), Real(0.0f), Real(0.1f)}, Real(n[2]), Real(n[3]), Real(n[4])});
    return evaluate_chiang(fibre, view_chiang(fibre, Real(n[5]), direction(n[6], n[7])), direction(n[8], n[9]));
  }

  /// The largest relative difference of float from double among the values that exceed 1e-6.
  [[nodiscard]] double error() const {
    const chiang_result<float> narrow = evaluated<float>();
    const chiang_result<double> wide = evaluated<double>();
    double worst = wide.density > 1e-6 ? test::relative_error(narrow.density, wide.density) : 0.0;
    for (int c = 0; c < 3; ++c) {
      if (wide.value[c] > 1e-6) worst = std::max(worst, test::relative_error(narrow.value[c], wide.value[c]));
    }
    return worst;
  }
};

/// The worst of 40,000 draws, made worse by 20,000 steps that each change one number.
double worst_by_climbing(float least_eta, float most_eta, float least_roughness) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  const auto draw = [&](float low, float high) { return low + (high - low) * share(generator); };
  drawn_pair worst{};
  double error = 0.0;
  const auto see = [&](const drawn_pair& one) {
    const double seen = one.error();
    if (seen > error) {
      error = seen;
      worst = one;
    }
  };
  int above = 0;
  for (int k = 0; k < 40000; ++k) {
    drawn_pair one{{draw(least_eta, most_eta), draw(0.0f, 3.0f), least_roughness, least_roughness, draw(-0.17f, 0.17f),
                    draw(-1.0f, 1.0f), draw(-1.0f, 1.0f), draw(0.0f, 6.28f), draw(-1.0f, 1.0f), draw(0.0f, 6.28f)}};
    for (const std::size_t roughness : {2u, 3u})
      one.number[roughness] += (1.0f - least_roughness) * std::pow(draw(0.0f, 1.0f), 3.0f);
    if (k % 2 == 0) one.number[8] = std::clamp(draw(-0.1f, 0.1f) - one.number[6], -1.0f, 1.0f);  // by the mirror cone
    see(one);
    above += one.error() > 3e-6 ? 1 : 0;
  }
  CHECK(above < 800);  // 2 in 100
  for (int k = 0; k < 20000; ++k) {
    drawn_pair one = worst;
    const float step = std::pow(10.0f, draw(-6.0f, -1.0f));
    one.number[generator() % one.number.size()] *= 1.0f + draw(-step, step);
    if (one.in_range(least_eta, most_eta, least_roughness)) see(one);
  }
  return error;
}

}  // namespace

TEST_CASE("float is within 5e-5 of double for hair, wherever f or the density exceeds 1e-6") {
  const double worst = worst_by_climbing(1.4f, 1.8f, 0.08f);
  MESSAGE("largest relative difference ", worst);
  CHECK(worst < 5e-5);
}

TEST_CASE("float is within 2.5e-4 of double for any index from 1.1 to 3 and roughness from 0.05 on") {
  const double worst = worst_by_climbing(1.1f, 3.0f, 0.05f);
  MESSAGE("largest relative difference ", worst);
  CHECK(worst < 2.5e-4);
}
