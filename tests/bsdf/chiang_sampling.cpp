// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_sampling.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

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

const std::array<setting, 4> settings = {setting{{1.55f, {0.1f, 0.4f, 0.9f}, 0.3f, 0.3f, 0.035f}, 0.3f, 0.3},
                                         setting{{1.55f, {0.0f, 0.2f, 2.0f}, 0.15f, 0.5f, -0.1f}, -0.8f, -1.0},
                                         setting{{1.4f, {1.0f, 1.0f, 0.1f}, 0.6f, 0.2f, 0.17f}, 0.95f, 1.3},
                                         setting{{1.7f, {0.05f, 0.05f, 0.3f}, 1.0f, 1.0f, 0.0f}, 0.0f, 0.0}};

}  // namespace

TEST_CASE("samples are distributed as the density says: χ² over 96 cells of equal area") {
  const int rows = 8;
  const int columns = 12;
  const int draws = 200000;
  for (const setting& s : settings) {
    const auto fibre = make_chiang_fibre(s.parameters);
    const auto view = view_chiang(fibre, s.h, fibre_direction_of(test::unit_vector<float>(s.theta, 0.5)));
    std::vector<double> observed(rows * columns), expected(rows * columns);
    std::uint32_t state = 12345u;  // a fixed stream of independent numbers
    const auto draw = [&] {
      state = state * 1664525u + 1013904223u;
      std::uint32_t x = state;
      x ^= x >> 16u;
      x *= 0x7feb352du;
      x ^= x >> 15u;
      x *= 0x846ca68bu;
      x ^= x >> 16u;
      return static_cast<float>(x >> 8u) * 0x1p-24f;
    };
    for (int k = 0; k < draws; ++k) {
      const float a = draw();
      const float b = draw();
      const float c = draw();
      const float d = draw();
      const glm::vec3 w = sample_chiang(fibre, view, std::array<float, 4>{a, b, c, d}).direction;
      const int row = std::min(static_cast<int>((w.x + 1.0f) * 0.5f * rows), rows - 1);
      const double azimuth = std::atan2(static_cast<double>(w.z), static_cast<double>(w.y)) + pi;
      const int column = std::min(static_cast<int>(azimuth / (2.0 * pi) * columns), columns - 1);
      observed[static_cast<std::size_t>(row * columns + column)] += 1.0;
    }
    const int fine = 24;  // per cell and axis
    for (int i = 0; i < rows * fine; ++i) {
      const double x = 2.0 * (i + 0.5) / (rows * fine) - 1.0;
      for (int k = 0; k < columns * fine; ++k) {
        const double azimuth = 2.0 * pi * (k + 0.5) / (columns * fine) - pi;
        const glm::vec3 w = test::unit_vector<float>(std::asin(x), azimuth);
        expected[static_cast<std::size_t>(i / fine * columns + k / fine)] +=
            static_cast<double>(chiang_density(fibre, view, fibre_direction_of(w))) * draws * 4.0 * pi /
            (rows * columns * fine * fine);
      }
    }
    double chi2 = 0.0;
    double rest_observed = 0.0;
    double rest_expected = 0.0;
    int cells = 0;
    for (std::size_t k = 0; k < observed.size(); ++k) {
      if (expected[k] < 10.0) {
        rest_observed += observed[k];
        rest_expected += expected[k];
      } else {
        chi2 += (observed[k] - expected[k]) * (observed[k] - expected[k]) / expected[k];
        ++cells;
      }
    }
    if (rest_expected > 10.0) {
      chi2 += (rest_observed - rest_expected) * (rest_observed - rest_expected) / rest_expected;
      ++cells;
    }
    CAPTURE(s.theta);
    CAPTURE(cells);
    // Four standard deviations of χ² above its mean.
    CHECK(chi2 < (cells - 1) + 4.0 * std::sqrt(2.0 * (cells - 1)));
    CHECK(rest_observed < rest_expected + 5.0 * std::sqrt(rest_expected + 1.0));
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

TEST_CASE("a fibre that is black in every lobe has density 0 and no NaN") {
  const float inf = std::numeric_limits<float>::infinity();
  const auto fibre = make_chiang_fibre<float>({1.0f, {inf, inf, inf}, 0.3f, 0.3f, 0.0f});
  const auto view = view_chiang(fibre, 0.2f, fibre_direction_of(test::unit_vector<float>(0.2, 0.0)));
  const auto sample = sample_chiang(fibre, view, std::array<float, 4>{0.5f, 0.5f, 0.5f, 0.5f});
  CHECK(sample.result.density < 1e-12f);
  CHECK(sample.result.value[0] < 1e-12f);
}
