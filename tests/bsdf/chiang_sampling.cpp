// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_sampling.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace pelage;

namespace {

constexpr double pi = std::numbers::pi;

/// The k-th point of an even cover of the unit 4-cube. [Roberts 2018: powers of the root of x⁵ = x + 1]
std::array<float, 4> even_point(int k) {
  std::array<float, 4> u;
  double step = 1.0;
  for (float& x : u) {
    step /= 1.16730397826141868;
    x = static_cast<float>(std::fmod(0.5 + step * k, 1.0));
    x = std::min(x, 0.99999994f);
  }
  return u;
}

struct setting {
  chiang_parameters<float> parameters;
  float h;
  double theta;
};

const std::array<setting, 5> settings = {setting{{1.55f, {0.1f, 0.4f, 0.9f}, 0.3f, 0.3f, 0.035f}, 0.3f, 0.3},
                                         setting{{1.55f, {0.0f, 0.2f, 2.0f}, 0.15f, 0.5f, -0.1f}, -0.8f, -1.0},
                                         setting{{1.4f, {1.0f, 1.0f, 0.1f}, 0.6f, 0.2f, 0.17f}, 0.95f, 1.3},
                                         setting{{1.7f, {0.05f, 0.05f, 0.3f}, 1.0f, 1.0f, 0.0f}, 0.0f, 0.0},
                                         setting{{1.55f, {0.3f, 0.6f, 0.9f}, 0.05f, 0.05f, -0.035f}, 0.6f, 0.4}};

}  // namespace

TEST_CASE("samples are distributed as the density says: χ² over 96 cells of equal area") {
  const int draws = 200000;
  for (const setting& s : settings) {
    const auto fibre = make_chiang_fibre(s.parameters);
    const auto view = view_chiang(fibre, s.h, fibre_direction_of(test::unit_vector<float>(s.theta, 0.5)));
    test::sphere_cells observed, expected;
    test::number_stream draw;
    for (int k = 0; k < draws; ++k) {
      observed.at(sample_chiang(fibre, view, draw.four()).direction) += 1.0;
    }
    // Points per cell and axis that the narrowest lobe needs.
    const double narrowest = std::min(std::sqrt(static_cast<double>(fibre.longitudinal[1].variance)),
                                      static_cast<double>(fibre.azimuthal.scale));
    const int rows = 8 * std::max(24, static_cast<int>(0.5 / narrowest));
    const int columns = 12 * std::max(24, static_cast<int>(0.5 / narrowest));
    for (int i = 0; i < rows; ++i) {
      const double x = 2.0 * (i + 0.5) / rows - 1.0;
      for (int k = 0; k < columns; ++k) {
        const double azimuth = 2.0 * pi * (k + 0.5) / columns;
        const glm::vec3 w = test::unit_vector<float>(std::asin(x), azimuth);
        expected.at(x, azimuth) += static_cast<double>(chiang_density(fibre, view, fibre_direction_of(w))) * draws *
                                   4.0 * pi / (rows * columns);
      }
    }
    CAPTURE(s.theta);
    CHECK(test::chi_square_excess(observed, expected) < 4.0);
  }
}

TEST_CASE("the mean weight of samples is the energy that leaves, within 1e-3") {
  for (const setting& s : settings) {
    const auto fibre = make_chiang_fibre(s.parameters);
    const auto view = view_chiang(fibre, s.h, fibre_direction_of(test::unit_vector<float>(s.theta, 0.5)));
    const int draws = 60000;
    std::array<double, 3> mean = {0.0, 0.0, 0.0};
    for (int k = 0; k < draws; ++k) {
      const auto sample = sample_chiang(fibre, view, even_point(k));
      for (std::uint32_t c = 0; c < 3; ++c) {
        mean[c] += static_cast<double>(sample.result.value[static_cast<int>(c)] / sample.result.density) / draws;
      }
    }
    for (std::uint32_t c = 0; c < 3; ++c) {
      double energy = 0.0;
      for (std::uint32_t p = 0; p < 4; ++p) {
        energy += static_cast<double>(view.attenuation[p][c]);
      }
      CHECK(std::abs(mean[c] - energy) < 1e-3);
    }
  }
}

TEST_CASE("a clear fibre's samples all have weight 1") {
  const auto fibre = make_chiang_fibre<float>({1.55f, {0.0f, 0.0f, 0.0f}, 0.2f, 0.2f, 0.05f});
  const auto view = view_chiang(fibre, 0.7f, fibre_direction_of(test::unit_vector<float>(0.9, 0.0)));
  for (int k = 0; k < 2000; ++k) {
    const auto sample = sample_chiang(fibre, view, even_point(k));
    REQUIRE(sample.result.density > 0.0f);
    REQUIRE(sample.result.value[0] / sample.result.density == doctest::Approx(1.0).epsilon(2e-6));
  }
}

TEST_CASE("sampled directions are unit vectors, whatever the numbers, and carry what evaluation says of them") {
  test::holds("unit length within 3e-7, density positive, value as evaluated", [](std::uint16_t a, std::uint16_t b,
                                                                                  std::uint16_t c, std::uint16_t d,
                                                                                  std::int8_t h, std::int8_t theta,
                                                                                  std::uint8_t rough) {
    const float beta = static_cast<float>(rough) / 255.0f;
    const auto fibre = make_chiang_fibre<float>({1.55f, {0.3f, 0.0f, 5.0f}, beta, 1.0f - beta, -0.1f});
    const auto eye = test::unit_vector<float>(theta / 128.0 * 1.5707, 2.0);
    const auto view = view_chiang(fibre, h / 127.0f, fibre_direction_of(eye));
    const auto number = [](std::uint16_t x) { return static_cast<float>(x) / 65536.0f; };
    const auto sample = sample_chiang(fibre, view, std::array<float, 4>{number(a), number(b), number(c), number(d)});
    const glm::dvec3 w(sample.direction);
    RC_ASSERT(std::abs(std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z) - 1.0) < 3e-7);
    const auto again = evaluate_chiang(fibre, view, fibre_direction_of(sample.direction));
    RC_ASSERT(again.value == sample.result.value);
    RC_ASSERT(again.density == sample.result.density);
    RC_ASSERT(std::isfinite(sample.result.density));
    RC_ASSERT(sample.lobe <= 3u);
  });
}

TEST_CASE("the ends of the unit interval and directions along the fibre are drawn from like others") {
  const float last = 0.99999994f;
  for (const float rough : {0.0f, 0.3f, 1.0f}) {
    const auto fibre = make_chiang_fibre<float>({1.55f, {0.0f, 0.3f, 1.0f}, rough, rough, 0.0f});
    for (const glm::vec3& eye : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 0, 1)}) {
      const auto view = view_chiang(fibre, 0.5f, fibre_direction_of(eye));
      for (int corner = 0; corner < 16; ++corner) {
        const auto end = [&](int bit) { return (corner >> bit & 1) != 0 ? last : 0.0f; };
        const auto sample = sample_chiang(fibre, view, std::array<float, 4>{end(0), end(1), end(2), end(3)});
        const glm::vec3 w = sample.direction;
        CHECK(std::abs(w.x * w.x + w.y * w.y + w.z * w.z - 1.0f) < 6e-7f);
        CHECK(std::isfinite(sample.result.density));
      }
    }
  }
}

TEST_CASE("a fibre that is not black draws no direction of density 0, at the corners of the unit cube neither") {
  const float last = 0.99999994f;
  int drawn = 0, without_density = 0, without_weight = 0;
  for (const float rough : {0.0f, 0.02f, 0.05f, 0.3f, 1.0f}) {
    for (const float tilt : {0.0f, -0.035f, 0.3f}) {
      for (const float h : {-1.0f, -0.999f, -0.3f, 0.0f, 0.8f, 1.0f}) {
        for (const double theta : {-pi / 2, -1.57, -1.2, 0.0, 0.4, 1.569, pi / 2}) {
          for (const float round : {rough, 1.0f - rough}) {
            const auto fibre = make_chiang_fibre<float>({1.55f, {0.1f, 1.0f, 30.0f}, rough, round, tilt});
            const auto view = view_chiang(fibre, h, fibre_direction_of(test::unit_vector<float>(theta, 2.0)));
            for (int point = 0; point < 256; ++point) {
              const auto number = [&](int bit) {
                return std::array<float, 4>{0.0f, 1e-8f, 0.5f, last}[static_cast<std::size_t>(point >> bit & 3)];
              };
              const auto sample =
                  sample_chiang(fibre, view, std::array<float, 4>{number(0), number(2), number(4), number(6)});
              ++drawn;
              without_density += sample.result.density > 0.0f ? 0 : 1;
              without_weight += std::isfinite(sample.result.value[0] / sample.result.density) ? 0 : 1;
            }
          }
        }
      }
    }
  }
  CAPTURE(drawn);
  CHECK(without_density == 0);
  CHECK(without_weight == 0);
}

TEST_CASE("nor does hair so black that it has lobes of almost no weight") {
  int without_density = 0;
  for (float sigma = 5.0f; sigma < 60.0f; sigma *= 1.05f) {
    for (const float along : {0.0f, 0.02f, 0.1f}) {
      for (const float round : {0.05f, 0.3f, 1.0f}) {
        const auto fibre = make_chiang_fibre<float>({1.55f, {sigma, sigma, sigma}, along, round, -0.035f});
        for (const double theta : {0.0, 0.7, 1.3}) {
          for (const float h : {0.0f, 0.9f}) {
            const auto view = view_chiang(fibre, h, fibre_direction_of(test::unit_vector<float>(theta, 2.0)));
            for (int point = 0; point < 81; ++point) {
              const auto number = [&](int power) {
                return std::array<float, 3>{0.0f, 0.3f, 0.99999994f}[static_cast<std::size_t>(point / power % 3)];
              };
              const auto sample =
                  sample_chiang(fibre, view, std::array<float, 4>{number(1), number(3), number(9), number(27)});
              without_density += sample.result.density > 0.0f ? 0 : 1;
            }
          }
        }
      }
    }
  }
  CHECK(without_density == 0);
}

TEST_CASE("a fibre that is black in every lobe has density 0 and no NaN") {
  const float inf = std::numeric_limits<float>::infinity();
  const auto fibre = make_chiang_fibre<float>({1.0f, {inf, inf, inf}, 0.3f, 0.3f, 0.0f});
  const auto view = view_chiang(fibre, 0.2f, fibre_direction_of(test::unit_vector<float>(0.2, 0.0)));
  const auto sample = sample_chiang(fibre, view, std::array<float, 4>{0.5f, 0.5f, 0.5f, 0.5f});
  CHECK(sample.result.density < 1e-12f);
  CHECK(sample.result.value[0] < 1e-12f);
}
