// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_far_field.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>
#include <sweep.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace pelage;

namespace {

constexpr double pi = std::numbers::pi;
using azimuths = std::array<std::array<double, 3>, 4>;

/// N_p A_p averaged over `count` even steps of γ, the near field at each.
std::vector<azimuths> by_brute_force(const chiang_fibre<double>& fibre, double theta_o, const std::vector<double>& phis,
                                     int count) {
  std::vector<azimuths> sums(phis.size(), azimuths{});
  const auto eye = fibre_direction_of(test::unit_vector<double>(theta_o, 0.0));
  for (int k = 0; k < count; ++k) {
    const double gamma = ((k + 0.5) / count - 0.5) * pi;
    const double weight = 0.5 * std::cos(gamma) * pi / count;
    const auto view = view_chiang(fibre, std::sin(gamma), eye);
    for (std::size_t i = 0; i < phis.size(); ++i) {
      for (std::size_t p = 0; p < 4; ++p) {
        const double n =
            p == 3 ? 0.5 / pi : chiang_round(fibre.azimuthal, view.towards[p], std::cos(phis[i]), std::sin(phis[i]));
        for (std::size_t c = 0; c < 3; ++c)
          sums[i][p][c] += weight * n * view.attenuation[p][c];
      }
    }
  }
  return sums;
}

std::vector<double> half_circle(int count) {
  std::vector<double> phis;
  for (int k = 0; k < count; ++k)
    phis.push_back(pi * k / (count - 1));
  return phis;
}

chiang_fibre<double> fibre_of(const std::array<double, 3>& sigma_a, double beta_m, double beta_n, double eta = 1.55) {
  return make_chiang_fibre<double>({eta, sigma_a, beta_m, beta_n, -0.035});
}

const std::array<std::array<double, 3>, 6> colours = {std::array<double, 3>{0.0, 0.0, 0.0},
                                                      absorption_of(melanin_of<double>(hair_colour::blond)),
                                                      absorption_of(melanin_of<double>(hair_colour::red)),
                                                      absorption_of(melanin_of<double>(hair_colour::brown)),
                                                      absorption_of(melanin_of<double>(hair_colour::black)),
                                                      std::array<double, 3>{2.0, 4.0, 1e30}};

constexpr std::array<double, 3> along = {0.08, 0.3, 0.9};  ///< β_m
constexpr std::array<double, 10> lights = {-1.5, -1.1, -0.7, -0.3, 0.0, 0.2, 0.6, 1.2, 1.5, 1.5707};

/// The greatest error over all eyes and azimuths by the greatest value there, at the worst of β_m, θ_i and channels.
double worst_error(const std::array<double, 3>& sigma_a, double beta_n, double eta) {
  const std::vector<double> phis = half_circle(41);
  std::array<std::array<std::array<double, 3>, lights.size()>, along.size()> error{}, greatest{};
  for (const double theta_o : {-1.5707, -1.569, -1.3, -0.8, -0.2, 0.0, 0.45, 0.6, 1.0, 1.45, 1.56}) {
    const auto eye = fibre_direction_of(test::unit_vector<double>(theta_o, 0.0));
    const auto fibre = fibre_of(sigma_a, 0.3, beta_n, eta);
    const auto expected = by_brute_force(fibre, theta_o, phis, beta_n < 0.12 ? 1200 : 400);
    for (std::size_t i = 0; i < phis.size(); ++i) {
      const auto round = chiang_far_lobes(fibre, eye.sine, eye.cosine, rotation_by(phis[i])).value;
      for (std::size_t m = 0; m < along.size(); ++m) {
        const auto other = fibre_of(sigma_a, along[m], beta_n, eta);
        const auto view = view_chiang(other, 0.0, eye);
        for (std::size_t l = 0; l < lights.size(); ++l) {
          const auto lobes =
              chiang_inclinations(other, view, fibre_direction_of(test::unit_vector<double>(lights[l], 0.0)));
          for (std::size_t c = 0; c < 3; ++c) {
            double is = 0.0, wanted = 0.0;
            for (std::size_t p = 0; p < 4; ++p) {
              is += lobes[p] * round[p][c];
              wanted += lobes[p] * expected[i][p][c];
            }
            error[m][l][c] = std::max(error[m][l][c], std::abs(is - wanted));
            greatest[m][l][c] = std::max(greatest[m][l][c], wanted);
          }
        }
      }
    }
  }
  double worst = 0.0;
  for (std::size_t m = 0; m < along.size(); ++m)
    for (std::size_t l = 0; l < lights.size(); ++l)
      for (std::size_t c = 0; c < 3; ++c)
        worst = std::max(worst, error[m][l][c] / greatest[m][l][c]);
  return worst;
}

/// How far a function goes up and down over the half circle.
double variation(const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k)
    sum += std::abs(values[k] - values[k - 1]);
  return sum;
}

}  // namespace

TEST_CASE("the average is within 0.01 of the greatest value at the same inclination of light, whatever the hair") {
  test::worst_case error;
  for (std::size_t colour = 0; colour < colours.size(); ++colour) {
    for (const double beta_n : {0.05, 0.12, 0.2, 0.3, 1.0})
      error.see(worst_error(colours[colour], beta_n, 1.55), {static_cast<double>(colour), beta_n});
  }
  for (const double eta : {1.4, 1.8}) {
    error.see(worst_error(colours[1], 0.05, eta), {eta, 0.05});
    error.see(worst_error(colours[4], 0.15, eta), {eta, 0.15});
  }
  error.see(worst_error(colours[1], 0.2534, 1.49), {1.49, 0.2534});
  error.see(worst_error(colours[1], 0.2579, 1.49), {1.49, 0.2579});
  MESSAGE("worst ", error);
  CHECK_MESSAGE(error.error < 0.01, error);
}

TEST_CASE("no cell shows as a band: over the azimuth each lobe goes as far up and down as the truth") {
  const std::vector<double> phis = half_circle(361);
  for (const double beta_n : {0.05, 0.1, 0.2, 0.4}) {
    for (const double theta_o : {0.0, -0.8, 1.2}) {
      const auto fibre = fibre_of({0.05, 0.5, 4.0}, 0.3, beta_n);
      const auto expected = by_brute_force(fibre, theta_o, phis, 1000);
      for (std::size_t p = 0; p < 3; ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
          std::vector<double> is, wanted;
          for (std::size_t i = 0; i < phis.size(); ++i) {
            is.push_back(
                chiang_far_lobes(fibre, std::sin(theta_o), std::cos(theta_o), rotation_by(phis[i])).value[p][c]);
            wanted.push_back(expected[i][p][c]);
          }
          CAPTURE(beta_n);
          CAPTURE(theta_o);
          CAPTURE(p);
          CAPTURE(c);
          CHECK(variation(is) == doctest::Approx(variation(wanted)).epsilon(0.05));
        }
      }
    }
  }
}

TEST_CASE("what evaluation says is M by the averaged azimuths, in float within 1e-4 of double") {
  test::holds("float is double", [] {
    const auto number = [](double low, double high) {
      return low + (high - low) * *rc::gen::inRange(0, 65537) / 65536.0;
    };
    const auto f = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    const double beta_m = f(number(0.08, 1.0)), beta_n = f(number(0.08, 1.0)), sigma = f(number(0.0, 4.0));
    const glm::vec3 eye = test::unit_vector<float>(number(-1.5, 1.5), number(-3.0, 3.0));
    const glm::vec3 light = test::unit_vector<float>(number(-1.5, 1.5), number(-3.0, 3.0));
    const auto exact = evaluate_chiang_far(make_chiang_fibre<double>({1.55, {sigma, 0.0, 1.0}, beta_m, beta_n, -0.035}),
                                           fibre_direction_of(glm::dvec3(eye)), fibre_direction_of(glm::dvec3(light)));
    const auto is = evaluate_chiang_far(make_chiang_fibre<float>({1.55f,
                                                                  {static_cast<float>(sigma), 0.0f, 1.0f},
                                                                  static_cast<float>(beta_m),
                                                                  static_cast<float>(beta_n),
                                                                  -0.035f}),
                                        fibre_direction_of(eye), fibre_direction_of(light));
    for (int c = 0; c < 3; ++c)
      RC_ASSERT(std::abs(static_cast<double>(is.value[c]) - exact.value[c]) <= 1e-4 * exact.value[c] + 1e-6);
    RC_ASSERT(std::abs(static_cast<double>(is.density) - exact.density) <= 1e-4 * exact.density + 1e-6);
  });
}

TEST_CASE("seen from afar a clear fibre still sends out all light, and the density integrates to 1") {
  for (const float beta_n : {0.05f, 0.1f, 0.3f, 0.6f, 1.0f}) {
    for (const float sigma : {0.0f, 0.5f, 1e6f}) {
      const auto fibre = make_chiang_fibre<float>({1.55f, {0.0f, sigma, sigma}, 0.3f, beta_n, -0.05f});
      for (const double theta : {0.0, 0.8, -1.4}) {
        const auto eye = fibre_direction_of(test::unit_vector<float>(theta, 0.0));
        // ∫ M cos θ dθ is 1, so that the azimuths are all of it.
        const int count = 512;
        double energy = 0.0, density = 0.0;
        for (int k = 0; k < count; ++k) {
          const auto round =
              chiang_far_lobes(fibre, eye.sine, eye.cosine, rotation_by(static_cast<float>((k + 0.5) * pi / count)));
          for (std::size_t p = 0; p < 4; ++p) {
            energy += static_cast<double>(round.value[p][0]) * 2.0 * pi / count;
            density += static_cast<double>(round.density[p]) * 2.0 * pi / count;
          }
        }
        CAPTURE(beta_n);
        CAPTURE(sigma);
        CAPTURE(theta);
        CHECK(energy == doctest::Approx(1.0).epsilon(3e-4));
        CHECK(density == doctest::Approx(1.0).epsilon(3e-4));
      }
    }
  }
  const auto fibre = make_chiang_fibre<float>({1.55f, {0.0f, 0.4f, 2.0f}, 0.3f, 0.3f, 0.05f});
  const auto eye = fibre_direction_of(test::unit_vector<float>(0.8, 0.0));
  const auto far = [&](const glm::vec3& light) { return evaluate_chiang_far(fibre, eye, fibre_direction_of(light)); };
  CHECK(test::integrate_sphere<float>(30, 60, [&](const glm::vec3& w) { return far(w).value[0]; }) ==
        doctest::Approx(1.0).epsilon(3e-4));
  CHECK(test::integrate_sphere<float>(30, 60, [&](const glm::vec3& w) { return far(w).density; }) ==
        doctest::Approx(1.0).epsilon(3e-4));
}

TEST_CASE("far samples are distributed as the density says: χ² over 96 cells of equal area") {
  struct setting {
    chiang_parameters<float> parameters;
    double theta;
  };
  const std::array<setting, 6> settings = {setting{{1.55f, {0.1f, 0.4f, 0.9f}, 0.3f, 0.3f, -0.035f}, 0.3},
                                           setting{{1.55f, {0.0f, 0.2f, 2.0f}, 0.05f, 0.05f, -0.035f}, -0.6},
                                           setting{{1.55f, {3.0f, 6.0f, 11.0f}, 0.1f, 0.1f, 0.17f}, 1.2},
                                           setting{{1.7f, {0.05f, 0.05f, 0.3f}, 1.0f, 1.0f, 0.0f}, 0.0},
                                           setting{{1.4f, {0.3f, 0.3f, 0.3f}, 0.6f, 0.6f, -0.1f}, -1.0},
                                           setting{{1.55f, {0.0f, 0.0f, 0.0f}, 0.02f, 0.02f, 0.0f}, 0.1}};
  const int draws = 20000;
  for (const setting& s : settings) {
    const auto fibre = make_chiang_fibre(s.parameters);
    const auto eye = fibre_direction_of(test::unit_vector<float>(s.theta, 0.5));
    test::sphere_cells observed, expected;
    test::number_stream draw;
    for (int k = 0; k < draws; ++k) {
      observed.at(sample_chiang_far(fibre, eye, draw.four()).direction) += 1.0;
    }
    // The density is a sum of products: M over the rows, the rest over the columns.
    const int fine_rows = 800, fine_columns = 100;
    const double width = 2.0 * pi / test::sphere_cells::columns;
    std::array<std::array<double, 4>, test::sphere_cells::columns> round = {};
    for (std::size_t column = 0; column < round.size(); ++column) {
      for (int k = 0; k < fine_columns; ++k) {
        const double azimuth = (static_cast<double>(column) + (k + 0.5) / fine_columns) * width;
        const auto density =
            chiang_far_lobes(fibre, eye.sine, eye.cosine, rotation_by(static_cast<float>(azimuth - 0.5))).density;
        for (std::size_t p = 0; p < 4; ++p)
          round[column][p] += static_cast<double>(density[p]) * width / fine_columns;
      }
    }
    const auto view = view_chiang(fibre, 0.0f, eye);
    for (int row = 0; row < test::sphere_cells::rows; ++row) {
      std::array<double, 4> inclinations = {};
      for (int i = 0; i < fine_rows; ++i) {
        const double x = 2.0 * (row + (i + 0.5) / fine_rows) / test::sphere_cells::rows - 1.0;
        const auto m =
            chiang_inclinations(fibre, view, fibre_direction_of(test::unit_vector<float>(std::asin(x), 0.0)));
        for (std::size_t p = 0; p < 4; ++p)
          inclinations[p] += 2.0 * static_cast<double>(m[p]) / (test::sphere_cells::rows * fine_rows);
      }
      for (int column = 0; column < test::sphere_cells::columns; ++column) {
        const double azimuth = (column + 0.5) * width;
        for (std::size_t p = 0; p < 4; ++p)
          expected.at(2.0 * (row + 0.5) / test::sphere_cells::rows - 1.0, azimuth) +=
              draws * inclinations[p] * round[static_cast<std::size_t>(column)][p];
      }
    }
    CAPTURE(s.theta);
    CAPTURE(s.parameters.beta_n);
    CHECK(test::chi_square_excess(observed, expected) < 4.0);
  }
}

TEST_CASE("a far sample carries what evaluation says, has density wherever it has value, and an even weight") {
  test::number_stream draw;
  double least_mean = 10.0, greatest_mean = 0.0;
  int without_density = 0, different = 0, not_unit = 0;
  const auto see = [&](const chiang_fibre<float>& fibre, const glm::vec3& eye, const std::array<float, 4>& u) {
    const auto from = fibre_direction_of(eye);
    const auto sample = sample_chiang_far(fibre, from, u);
    const auto again = evaluate_chiang_far(fibre, from, fibre_direction_of(sample.direction));
    different += again.value == sample.result.value && again.density == sample.result.density ? 0 : 1;
    without_density += sample.result.density > 0.0f && std::isfinite(sample.result.density) ? 0 : 1;
    const glm::dvec3 w(sample.direction);
    not_unit += std::abs(std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z) - 1.0) < 3e-7 ? 0 : 1;
    return sample.result.value[0] / sample.result.density;
  };
  // A clear fibre sends all: all weights are 1 within the rule's error.
  for (const float beta : {0.05f, 0.3f, 1.0f}) {
    const auto clear = make_chiang_fibre<float>({1.55f, {0.0f, 0.0f, 0.0f}, beta, beta, -0.035f});
    for (int k = 0; k < 500; ++k) {
      const glm::vec3 eye = test::unit_vector<float>(3.1 * static_cast<double>(draw()) - 1.55, 1.0);
      const auto weight = static_cast<double>(see(clear, eye, draw.four()));
      least_mean = std::min(least_mean, weight);
      greatest_mean = std::max(greatest_mean, weight);
    }
  }
  CHECK(least_mean > 0.99);
  CHECK(greatest_mean < 1.01);
  // The corners of the unit cube, and directions along the fibre.
  for (const float rough : {0.0f, 0.05f, 1.0f}) {
    for (const float round : {rough, 1.0f - rough}) {
      const auto fibre = make_chiang_fibre<float>({1.55f, {0.0f, 1.0f, 30.0f}, rough, round, -0.035f});
      for (const glm::vec3& eye : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 0, 1),
                                   test::unit_vector<float>(1.57, 2.0), test::unit_vector<float>(0.4, -2.0)}) {
        for (int point = 0; point < 81; ++point) {
          const auto number = [&](int power) {
            return std::array<float, 3>{0.0f, 0.5f, 0.99999994f}[static_cast<std::size_t>(point / power % 3)];
          };
          (void)see(fibre, eye, {number(1), number(3), number(9), number(27)});
        }
      }
    }
  }
  CHECK(different == 0);
  CHECK(without_density == 0);
  CHECK(not_unit == 0);
}

TEST_CASE("hair so black that it has paths of almost no weight draws no far direction of density 0") {
  int without_density = 0;
  for (float sigma = 5.0f; sigma < 60.0f; sigma *= 1.2f) {
    for (const float along : {0.02f, 0.1f}) {
      for (const float round : {0.05f, 1.0f}) {
        const auto fibre = make_chiang_fibre<float>({1.55f, {sigma, sigma, sigma}, along, round, -0.035f});
        for (const double theta : {0.0, 1.0, 1.5}) {
          const auto eye = fibre_direction_of(test::unit_vector<float>(theta, 2.0));
          for (int point = 0; point < 81; ++point) {
            const auto number = [&](int power) {
              return std::array<float, 3>{0.0f, 0.3f, 0.99999994f}[static_cast<std::size_t>(point / power % 3)];
            };
            const auto sample = sample_chiang_far(fibre, eye, {number(1), number(3), number(9), number(27)});
            without_density += sample.result.density > 0.0f ? 0 : 1;
          }
        }
      }
    }
  }
  CHECK(without_density == 0);
}

TEST_CASE("a fibre that is black in every lobe has no far density and no NaN") {
  auto fibre = make_chiang_fibre<float>({1.0f, {1e30f, 1e30f, 1e30f}, 0.3f, 0.3f, 0.0f});
  fibre.tints = {0.0f, 0.0f, 0.0f, 0.0f};
  const auto eye = fibre_direction_of(test::unit_vector<float>(0.2, 0.0));
  const auto sample = sample_chiang_far(fibre, eye, std::array<float, 4>{0.5f, 0.5f, 0.5f, 0.5f});
  CHECK(sample.result.density == 0.0f);
  CHECK(sample.result.value[0] == 0.0f);
}
