// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/ray_cone.hpp>

#include "property.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::test {

static_assert(radius_at(perspective_cone(1.0f, 4, pixel_footprint::inscribed), 2.0f) == 0.5f);

TEST_CASE("a perspective pixel's disc touches the sides of the pixel, projected back to its depth") {
  worst_case worst;
  for (int i = 0; i < 10'000; ++i) {
    const auto [u, v, w, row] = even_point<4>(i);
    const float tan_half_fov = static_cast<float>(on_log_scale(u, 1e-3, 1e3));
    const int height = static_cast<int>(on_log_scale(v, 1.0, 1e5));
    const float depth = static_cast<float>(on_log_scale(w, 1e-4, 1e4));
    // A projection maps y / depth / tan to [-1, 1] from the bottom to the top of the image.
    const auto side_at = [&](int pixel) { return (2.0 * pixel / height - 1.0) * tan_half_fov * depth; };
    const int pixel = static_cast<int>(row * height);
    const double radius = 0.5 * (side_at(pixel + 1) - side_at(pixel));
    worst.see(
        relative_error(radius_at(perspective_cone(tan_half_fov, height, pixel_footprint::inscribed), depth), radius),
        {tan_half_fov, static_cast<double>(height), depth});
  }
  CHECK_MESSAGE(worst.error < 2e-7, worst);
}

TEST_CASE("the discs of an orthographic map stand side by side across its extent, at every depth") {
  worst_case worst;
  for (int i = 0; i < 10'000; ++i) {
    const auto [u, v, w] = even_point<3>(i);
    const float extent = static_cast<float>(on_log_scale(u, 1e-3, 1e3));
    const int texels = static_cast<int>(on_log_scale(v, 1.0, 1e5));
    const float depth = static_cast<float>(2e4 * w - 1e4);
    const float diameter = 2.0f * radius_at(orthographic_cone(extent, texels, pixel_footprint::inscribed), depth);
    worst.see(relative_error(static_cast<double>(diameter) * texels, extent), {extent, static_cast<double>(texels)});
  }
  CHECK_MESSAGE(worst.error < 1e-7, worst);
}

TEST_CASE("only a perspective cone has a slope, only an orthographic one a base") {
  CHECK(perspective_cone(0.5f, 100).base == 0.0f);
  CHECK(perspective_cone(0.5f, 100).slope > 0.0f);
  CHECK(orthographic_cone(0.5f, 100).base > 0.0f);
  CHECK(orthographic_cone(0.5f, 100).slope == 0.0f);
}

constexpr pixel_footprint footprints[]{pixel_footprint::inscribed, pixel_footprint::equal_area, pixel_footprint::yu};

TEST_CASE("a footprint scales the disc of either projection") {
  CHECK(disc_radius<double>(pixel_footprint::inscribed) == 0.5);
  CHECK(3.141592653589793 * std::pow(disc_radius<double>(pixel_footprint::equal_area), 2) == doctest::Approx(1.0));
  CHECK(disc_radius<double>(pixel_footprint::yu) == 1.0);
  for (const pixel_footprint footprint : footprints) {
    const double pixel = 2.0 * 0.3 / 480.0;  // at depth 1
    CHECK(perspective_cone(0.3, 480, footprint).slope == doctest::Approx(disc_radius<double>(footprint) * pixel));
    CHECK(orthographic_cone(12.0, 24, footprint).base == doctest::Approx(0.5 * disc_radius<double>(footprint)));
  }
}

/// The part of a unit square on one side of a line at this distance from its centre: its shadow along the line is a
/// trapezium.
double square_beside(double distance, double angle) {
  const double cosine = std::abs(std::cos(angle)), sine = std::abs(std::sin(angle));
  const double foot = 0.5 * (cosine + sine), top = 0.5 * std::abs(cosine - sine), height = 1.0 / std::max(cosine, sine);
  const double from = std::min(std::abs(distance), foot);
  const double past_top = std::max(from - top, 0.0);
  const double middle = height * (from - (past_top > 0.0 ? past_top * past_top / (2.0 * (foot - top)) : 0.0));
  return 0.5 + (distance < 0.0 ? -middle : middle);
}

/// How a footprint covers pixels with a long straight fibre of this radius in pixels.
struct footprint_errors {
  double width = 0.0;                   ///< all pixels' shares together, on average, over the fibre's width
  double least = infinity, most = 0.0;  ///< what pixels on a line across an upright fibre have together, over its width
  double rms = 0.0;                     ///< from the fibre's area in a pixel, in pixels nearer to its axis than a side
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

footprint_errors errors_of(pixel_footprint footprint, double radius) {
  const double disc = disc_radius<double>(footprint);
  const auto share = [&](double offset) { return disc_strip_share(offset, radius, disc); };
  footprint_errors e;
  const int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double offset = 2.0 * (i + 0.5) / steps - 1.0;
    e.width += share(2.0 * offset) * 4.0 / steps / (2.0 * radius);
    double across = 0.0;
    for (int pixel = -3; pixel <= 3; ++pixel)
      across += share(offset + pixel) / (2.0 * radius);
    e.least = std::min(e.least, across);
    e.most = std::max(e.most, across);
    const double angle = 1.6180339887498949 * i;
    const double exact = square_beside(offset + radius, angle) - square_beside(offset - radius, angle);
    e.rms += (share(offset) - exact) * (share(offset) - exact) / steps;
  }
  e.rms = std::sqrt(e.rms);
  return e;
}

TEST_CASE("every footprint keeps a fibre's area, and the disc of the pixel's area is nearest to the pixel") {
  for (const double radius : {0.01, 0.1, 0.25}) {
    CAPTURE(radius);
    for (const pixel_footprint footprint : footprints) {
      const footprint_errors e = errors_of(footprint, radius);
      CHECK(e.width == doctest::Approx(1.0).epsilon(1e-3));
      CHECK(e.rms >= errors_of(pixel_footprint::equal_area, radius).rms);
    }
  }
}

TEST_CASE("a thin fibre's coverage swings with its place, and is off, by what the header says") {
  const auto check = [](pixel_footprint footprint, double least, double most, double rms) {
    CAPTURE(static_cast<int>(footprint));
    const footprint_errors e = errors_of(footprint, 1e-3);
    CHECK(std::abs(e.least - least) < 0.01);
    CHECK(std::abs(e.most - most) < 0.01);
    CHECK(std::abs(e.rms / 2e-3 - rms) < 0.01);
  };
  check(pixel_footprint::inscribed, 0.05, 1.27, 0.15);
  check(pixel_footprint::equal_area, 0.72, 1.13, 0.09);
  check(pixel_footprint::yu, 0.65, 1.10, 0.37);
}

TEST_CASE("a depth behind the eye counts as 0") {
  const ray_cone<float> cone{0.25f, 0.5f};
  for (const float depth : {0.0f, -1.0f, -std::numeric_limits<float>::infinity()}) {
    CHECK(radius_at(cone, depth) == 0.25f);
  }
}

}  // namespace pelage::test
