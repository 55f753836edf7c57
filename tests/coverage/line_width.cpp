// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/line_width.hpp>

#include "property.hpp"
#include "sweep.hpp"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST_CASE("the diagonal ratio is a line's length over the pixels that draw it") {
  holds("counted from end to end", [] {
    const int columns = *rc::gen::inRange(-2000, 2001);
    const int rows = *rc::gen::inRange(-2000, 2001);
    RC_PRE(columns != 0 || rows != 0);
    const int pixels = std::max(std::abs(columns), std::abs(rows));  // one a column, or one a row of a steep line
    const float ratio = diagonal_ratio(glm::vec2(columns, rows));
    RC_ASSERT(relative_error(ratio, std::hypot(columns, rows) / pixels) < 2e-7);
    RC_ASSERT(ratio >= 1.0f && ratio <= std::sqrt(2.0f));
  });
}

TEST_CASE("a segment of length 0, or NaN, has the ratio of a straight line") {
  for (const glm::vec2 extent : {glm::vec2(0.0f), glm::vec2(nan, 1.0f), glm::vec2(1.0f, nan), glm::vec2(nan)}) {
    CHECK(diagonal_ratio(extent) == 1.0f);
    CHECK(line_width_share(extent, 0.25f, 0.5f) == 0.5f);
  }
}

/// How a one-pixel line differs from the fibre in one column of pixels: in all of them together, and in the pixel
/// that the line draws.
struct column_error {
  double sum;
  double drawn;
};

/// A fibre of this width that passes `offset` in [-½, ½) pixels above the centre of the column's drawn pixel.
column_error error_in_column(double width, double angle, double offset) {
  const double across = std::cos(angle);
  const double share = line_width_share(glm::dvec2(across, std::sin(angle)), 0.5 * width, 0.5);
  column_error error{share, share - disc_strip_share(offset * across, 0.5 * width, 0.5)};
  for (int row = -2; row <= 2; ++row) {
    error.sum -= disc_strip_share((offset + row) * across, 0.5 * width, 0.5);
  }
  return error;
}

TEST_CASE("over offsets and angles a column weighs as much as the fibre in it, up to a width of 0.7 pixels") {
  for (const double width : {0.01, 0.05, 0.2, 0.5, 0.7}) {
    const int count = 20'000;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
      const auto [u, v] = even_point<2>(i);
      sum += error_in_column(width, u * 0.7853981633974483, v - 0.5).sum;
    }
    CHECK(std::abs(sum / count) < 1e-3 * width);
  }
}

TEST_CASE("in the single pixel the error is a quarter of the width") {
  struct measured {
    double width, rms;
  };
  for (const measured expected : {measured{0.05, 0.012}, {0.2, 0.051}, {0.5, 0.142}, {1.0, 0.229}}) {
    const int count = 20'000;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
      const auto [u, v] = even_point<2>(i);
      squares += sqr(error_in_column(expected.width, u * 0.7853981633974483, v - 0.5).drawn);
    }
    CHECK(std::sqrt(squares / count) == doctest::Approx(expected.rms).epsilon(0.01));
  }
}

TEST_CASE("a fibre wider than the line saturates at 1") {
  CHECK(line_width_share(glm::vec2(1.0f, 0.0f), 0.5f, 0.5f) == 1.0f);
  CHECK(line_width_share(glm::vec2(1.0f, 1.0f), 0.4f, 0.5f) == 1.0f);
  CHECK(line_width_share(glm::vec2(1.0f, 1.0f), inf, 0.5f) == 1.0f);
}

TEST_CASE("a fibre or a pixel without width, or a NaN radius, has no share") {
  for (const float none : {0.0f, -1.0f, nan}) {
    CHECK(line_width_share(glm::vec2(1.0f, 1.0f), none, 0.5f) == 0.0f);
    CHECK(line_width_share(glm::vec2(1.0f, 1.0f), 0.1f, none) == 0.0f);
  }
}

TEST_CASE("the thesis's coverage has the values that Eq. 1.1 gives by hand") {
  const double root = 1.4142135623730951;
  CHECK(mean_diagonal_ratio(0.0) == doctest::Approx((1.0 + root) / 2.0).epsilon(1e-15));
  CHECK(mean_diagonal_ratio(1.0) == doctest::Approx((1.0 + root) / 2.0 - 0.25).epsilon(1e-15));
  CHECK(mean_line_width_share(0.1, 0.5) == doctest::Approx(0.231421356237309).epsilon(1e-14));  // w = 0.2
  CHECK(mean_line_width_share(0.2, 0.5) == doctest::Approx(0.442842712474619).epsilon(1e-14));  // w = 0.4
  CHECK(mean_line_width_share(0.5, 0.5) == doctest::Approx(0.957106781186547).epsilon(1e-14));  // w = 1
  CHECK(mean_line_width_share(0.5f, 0.5f) == doctest::Approx(0.9571068f));
  CHECK(mean_line_width_share(0.51f, 0.5f) == 1.0f);
  CHECK(mean_line_width_share(inf, 0.5f) == 1.0f);
  for (const float none : {0.0f, -1.0f, nan}) {
    CHECK(mean_line_width_share(none, 0.5f) == 0.0f);
    CHECK(mean_line_width_share(0.1f, none) == 0.0f);
  }
  CHECK(mean_line_width_share(inf, inf) == 0.0f);
}

/// The share of a pixel's square that a fibre through its middle covers: its chords, summed up across the fibre.
double square_share(double width, double angle) {
  const double across = std::sin(angle);
  const double along = std::cos(angle);
  const int steps = 2000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double h = width * ((i + 0.5) / steps - 0.5);  // the chord through h (-across, along), from side to side
    double begin = -2.0;
    double end = 2.0;
    const auto cut = [&](double at, double slope) {
      if (slope < 1e-12) {
        if (std::abs(at) > 0.5) end = begin;
        return;
      }
      begin = std::max(begin, (-0.5 - at) / slope);
      end = std::min(end, (0.5 - at) / slope);
    };
    cut(-h * across, along);
    cut(h * along, across);
    sum += std::max(0.0, end - begin);
  }
  return sum * width / steps;
}

TEST_CASE("through the pixel's middle the thesis's coverage is within 0.043 of the square's share at any angle") {
  double worst = 0.0;
  for (int w = 1; w <= 50; ++w) {
    for (int step = 0; step <= 45; ++step) {
      const double exact = square_share(w / 50.0, step * 0.017453292519943295);
      worst = std::max(worst, std::abs(mean_line_width_share(w / 100.0, 0.5) - exact));
    }
  }
  CHECK(worst < 0.0430);
  CHECK(worst > 0.0425);
}

TEST_CASE("a line of the thesis's coverage weighs too much along rows and too little along diagonals") {
  const auto weight = [](double width, double angle) {  // of the pixels over that of the fibre, a length of both
    return mean_line_width_share(0.5 * width, 0.5) * std::cos(angle) / width;
  };
  const double diagonal = 0.7853981633974483;
  CHECK(weight(1e-6, 0.0) == doctest::Approx(1.21).epsilon(0.005));
  CHECK(weight(1e-6, diagonal) == doctest::Approx(0.85).epsilon(0.005));
  CHECK(weight(1.0, 0.0) == doctest::Approx(0.96).epsilon(0.005));
  CHECK(weight(1.0, diagonal) == doctest::Approx(0.68).epsilon(0.005));
}

}  // namespace pelage::test
