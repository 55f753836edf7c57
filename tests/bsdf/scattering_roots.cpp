// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/scattering_roots.hpp>

#include <property.hpp>
#include <sweep.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace pelage;

namespace {

constexpr double pi = std::numbers::pi;

double excess_of(double eta) {
  return eta * eta - 1.0;
}

/// φ(p, h) of the paper.
double azimuth(int path, double h, double eta) {
  return 2.0 * path * std::asin(h / eta) - 2.0 * std::asin(h) + path * pi;
}

/// How many h have φ(p, h) = φ: changes of sign on a grid of sin-spaced offsets.
int count_by_scan(int path, double phi, double eta) {
  int count = 0;
  double last = 0.0;
  for (int k = 0; k <= 4000; ++k) {
    const double h = std::sin(pi * (k / 4000.0 - 0.5));
    const double residual = wrapped_angle(azimuth(path, h, eta) - phi);
    if (k > 0 && residual * last < 0.0 && std::abs(residual - last) < 1.0) {
      ++count;
    }
    last = residual;
  }
  return count;
}

}  // namespace

TEST_CASE("every root that is found is one, to double's last digits") {
  test::holds("φ(p, h) = φ within 1e-13 (1 + |dφ/dγ|)", [](std::uint8_t path_bits, std::int16_t a, std::uint16_t b) {
    const int path = path_bits % 3;
    const double phi = a / 32768.0 * (path == 2 ? 0.6 : pi);
    const double eta = 1.05 + b / 65536.0 * 2.5;
    const auto roots = find_scattering_roots(path, phi, excess_of(eta));
    for (std::uint32_t k = 0; k < roots.count; ++k) {
      const auto root = roots.root[k];
      // By the angle rather than by h, whose digits are few at the edge.
      const double gamma = std::atan2(root.sine, root.cosine);
      const double inside = std::asin(root.sine / eta);
      const double residual = wrapped_angle(2.0 * path * inside - 2.0 * gamma + path * pi - phi);
      RC_ASSERT(std::abs(residual) < 2e-13);
      RC_ASSERT(std::abs(root.sine * root.sine + root.cosine * root.cosine - 1.0) < 1e-14);
      const double slope = path * root.cosine / std::sqrt(eta * eta - root.sine * root.sine) - 1.0;
      RC_ASSERT(std::abs(slope - root.slope) < 1e-13);
    }
  });
}

TEST_CASE("no root is missed and none is found twice") {
  int wrong = 0;
  std::vector<int> seen(4, 0);
  for (const double eta : {1.2, 1.4, 1.42, 1.55, 1.8, 1.99, 2.0, 2.3, 4.0}) {
    for (int path = 0; path <= 2; ++path) {
      for (int k = -40; k <= 40; ++k) {
        const double phi = k == 40 ? 3.1 : path == 2 ? k * 0.0201 + 0.0003 : k * 0.077 + 0.0007;
        const auto roots = find_scattering_roots(path, phi, excess_of(eta));
        wrong += static_cast<int>(roots.count) == count_by_scan(path, phi, eta) ? 0 : 1;
        ++seen[roots.count];
        for (std::uint32_t a = 0; a < roots.count; ++a) {
          for (std::uint32_t b = 0; b < a; ++b) {
            CHECK(std::abs(roots.root[a].sine - roots.root[b].sine) > 1e-6);
          }
        }
      }
    }
  }
  CHECK(wrong == 0);
  // All numbers of roots have come up: none, one, two where η′ < √2, three.
  CHECK(*std::min_element(seen.begin(), seen.end()) > 0);
}

TEST_CASE("the caustic at θ = 0 of hair is at h 0.7297 and φ 0.3249") {
  const auto caustic = find_caustic(excess_of(1.55));
  CHECK(caustic.sine == doctest::Approx(0.7297).epsilon(1e-4));
  CHECK(2.0 * caustic.half_azimuth == doctest::Approx(0.3249).epsilon(2e-4));
  CHECK(wrapped_angle(azimuth(2, caustic.sine, 1.55)) == doctest::Approx(2.0 * caustic.half_azimuth).epsilon(1e-13));
  CHECK(std::abs(azimuth_derivative(2, caustic.sine, 1.55)) < 1e-13);
  const double step = 1e-4;
  const double gamma = std::asin(caustic.sine);
  const auto half = [](double g) { return 2.0 * std::asin(std::sin(g) / 1.55) - g; };
  const double second = (half(gamma + step) - 2.0 * half(gamma) + half(gamma - step)) / (step * step);
  CHECK(-second == doctest::Approx(caustic.curvature).epsilon(1e-5));
}

TEST_CASE("from η′ = 2 on there is no caustic, and just below it lies at the axis") {
  CHECK(find_caustic(excess_of(2.0)).curvature == 0.0);
  CHECK(find_caustic(excess_of(5.0)).half_azimuth == 0.0);
  CHECK(find_caustic(excess_of(1.9999)).sine == doctest::Approx(std::sqrt(0.0004 / 3.0)).epsilon(1e-3));
}

TEST_CASE("dφ/dh is the derivative of φ, near the caustic as elsewhere") {
  const double caustic = find_caustic(excess_of(1.55)).sine;
  for (const double h : {0.0, 0.3, caustic - 1e-3, caustic, caustic + 1e-3, -caustic + 1e-2, 0.95, -0.99}) {
    for (int path = 0; path <= 2; ++path) {
      const double step = 1e-6;
      const double difference = (azimuth(path, h + step, 1.55) - azimuth(path, h - step, 1.55)) / (2.0 * step);
      CHECK(azimuth_derivative(path, h, 1.55) == doctest::Approx(difference).epsilon(1e-6).scale(0.1));
    }
  }
}

/// The worst error of a root of one precision against a wider one, by the bound that is promised for TRT: as a share of
/// max(1, 0.6/√excess)/min(1, |dφ/dh|); of the other paths' roots as it is.
template <class Narrow, class Wide>
void see_roots(int path, double phi, double excess, test::worst_case& worst) {
  const auto narrow_phi = static_cast<Narrow>(phi);
  const auto narrow_excess = static_cast<Narrow>(excess);
  const auto found = find_scattering_roots<Narrow>(path, narrow_phi, narrow_excess);
  const auto expected = find_scattering_roots<Wide>(path, narrow_phi, narrow_excess);
  if (found.count != expected.count) return;  // by the caustic or the edge
  for (std::uint32_t k = 0; k < found.count; ++k) {
    const auto& root = expected.root[k];
    const double steep = static_cast<double>(std::abs(2 * root.slope / root.cosine));
    if (!(steep >= 0.2)) continue;
    const double error = static_cast<double>(std::abs(static_cast<Wide>(found.root[k].sine) - root.sine));
    const double allowed = path == 2 ? std::max(1.0, 0.6 / std::sqrt(excess)) / std::min(1.0, steep) : 1.0;
    worst.see(error / allowed, {phi, excess});
  }
}

TEST_CASE("roots keep their digits over every index, in float and in double") {
  for (int path = 0; path <= 2; ++path) {
    test::worst_case narrow;
    test::worst_case wide;
    see_roots<float, double>(path, -0x1.6625e4p-7, 0x1.ea2b84p-8, narrow);
    see_roots<float, double>(path, 1.95384037, 6.6921916, narrow);
    for (int i = 0; i < 60000; ++i) {
      const auto [u, v] = test::even_point<2>(i);
      const double phi = (2.0 * u - 1.0) * (i % 2 == 0 ? 3.1415 : 0.9);  // at ±π two roots are one
      const double excess = test::on_log_scale(v, 1e-4, 1000.0);
      see_roots<float, double>(path, phi, excess, narrow);
      if (i % 4 == 0) see_roots<double, long double>(path, phi, excess, wide);
    }
    CHECK_MESSAGE(narrow.error < (path == 2 ? 1e-6 : 2.5e-7), narrow);
    CHECK_MESSAGE(wide.error < 2e-15, wide);
  }
}

TEST_CASE("roots of an azimuth of many turns lose what wrapping it loses") {
  for (int path = 0; path <= 2; ++path) {
    test::worst_case worst;
    for (int i = 0; i < 60000; ++i) {
      const auto [u, v] = test::even_point<2>(i);
      const auto phi = static_cast<float>((2.0 * u - 1.0) * (i % 2 == 0 ? 1000.0 : 7.0));
      const auto excess = static_cast<float>(test::on_log_scale(v, 1e-4, 1000.0));
      const double inside = std::remainder(static_cast<double>(phi), 2.0 * pi);
      const auto found = find_scattering_roots(path, phi, excess);
      const auto expected = find_scattering_roots<double>(path, inside, excess);
      if (found.count != expected.count || pi - std::abs(inside) < 1e-4) continue;
      for (std::uint32_t k = 0; k < found.count; ++k) {
        const auto& root = expected.root[k];
        const double steep = std::abs(2.0 * root.slope / root.cosine);
        const double allowed = path == 2 ? std::max(1.0, 0.6 / std::sqrt(excess)) / std::min(1.0, steep) : 1.0;
        if (steep >= 0.2) worst.see(std::abs(found.root[k].sine - root.sine) / allowed, {phi, excess});
      }
    }
    CHECK_MESSAGE(worst.error < (path == 2 ? 1e-6 : 7e-7), worst);
  }
}

TEST_CASE("a root's slope is dφ/dh in double and in float, down to the caustic") {
  const double phi_c = 2.0 * find_caustic(excess_of(1.55)).half_azimuth;
  for (const double off : {1e-2, 1e-3, 1e-4, 1e-6}) {
    const auto wide = find_scattering_roots(2, phi_c - off, excess_of(1.55));
    const auto narrow = find_scattering_roots(2, static_cast<float>(phi_c - off), static_cast<float>(excess_of(1.55)));
    REQUIRE(wide.count == 3u);
    REQUIRE(narrow.count == 3u);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto root = wide.root[k];
      CHECK(2.0 * root.slope / root.cosine ==
            doctest::Approx(azimuth_derivative(2, root.sine, 1.55)).epsilon(1e-9).scale(1e-3));
      // Rounding φ and η moves a root by the caustic by about √1e-7.
      const double tolerance = off > 5e-4 ? 2e-4 : 0.2;
      CHECK(static_cast<double>(narrow.root[k].slope) == doctest::Approx(root.slope).epsilon(tolerance));
    }
    // The two roots that meet have slopes of opposite sign, like √off.
    CHECK(wide.root[0].slope > 0.0);
    CHECK(wide.root[1].slope < 0.0);
    CHECK(wide.root[0].slope / std::sqrt(off) == doctest::Approx(-wide.root[1].slope / std::sqrt(off)).epsilon(0.1));
  }
}

TEST_CASE("on the caustic itself two of three roots coincide; beyond it one is left") {
  const double phi_c = 2.0 * find_caustic(excess_of(1.55)).half_azimuth;
  const auto at = find_scattering_roots(2, phi_c, excess_of(1.55));
  CHECK(at.count >= 1u);
  CHECK(find_scattering_roots(2, phi_c + 1e-9, excess_of(1.55)).count == 1u);
  CHECK(find_scattering_roots(2, phi_c - 1e-9, excess_of(1.55)).count == 3u);
}

TEST_CASE("-φ negates every root") {
  test::holds("same count, opposite offsets", [](std::int16_t a, std::uint8_t path_bits) {
    const int path = path_bits % 3;
    const double phi = (a == 0 ? 1 : a) / 32768.0 * (path == 2 ? 0.5 : pi);
    const auto one = find_scattering_roots(path, phi, excess_of(1.6));
    const auto other = find_scattering_roots(path, -phi, excess_of(1.6));
    RC_ASSERT(one.count == other.count);
    for (std::uint32_t k = 0; k < one.count; ++k) {
      RC_ASSERT(one.root[k].sine == -other.root[k].sine);
    }
  });
}

TEST_CASE("angles beyond a turn are wrapped and NaN has no roots") {
  CHECK(wrapped_angle(7.0) == doctest::Approx(7.0 - 2.0 * pi).epsilon(1e-14));
  CHECK(wrapped_angle(-100.0) == doctest::Approx(-100.0 + 32.0 * pi).epsilon(1e-13));
  CHECK(static_cast<double>(wrapped_angle(20.0f)) == doctest::Approx(20.0 - 6.0 * pi).epsilon(1e-6));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int path = 0; path <= 2; ++path) {
    CHECK(find_scattering_roots(path, nan, excess_of(1.55)).count == 0u);
    CHECK(find_scattering_roots(path, 0.1, excess_of(1.55)).count ==
          find_scattering_roots(path, 0.1 + 2.0 * pi, excess_of(1.55)).count);
  }
}
