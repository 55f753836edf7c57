// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/ray_cone.hpp>

#include "property.hpp"
#include "sweep.hpp"

#include <limits>

namespace pelage::test {

static_assert(radius_at(perspective_cone(1.0f, 4), 2.0f) == 0.5f);

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
    worst.see(relative_error(radius_at(perspective_cone(tan_half_fov, height), depth), radius),
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
    const float diameter = 2.0f * radius_at(orthographic_cone(extent, texels), depth);
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

TEST_CASE("a depth behind the eye counts as 0") {
  const ray_cone<float> cone{0.25f, 0.5f};
  for (const float depth : {0.0f, -1.0f, -std::numeric_limits<float>::infinity()}) {
    CHECK(radius_at(cone, depth) == 0.25f);
  }
}

}  // namespace pelage::test
