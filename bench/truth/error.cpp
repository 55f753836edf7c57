// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/error.hpp"

#include <algorithm>
#include <cmath>

namespace pelage::truth {

// With a and b the halves' noise and d the error, (d - a)(d - b) has the variance 2 d²σ² + σ⁴, and (a - b)⁴ the mean
// 12 σ⁴.
void squared_error::see(double estimate, double a, double b) {
  const double product = (estimate - a) * (estimate - b);
  const double spread = (a - b) * (a - b);
  sum += product;
  noise += spread * (spread / 12.0 + std::max(0.0, product));
  ++count;
}

squared_error& squared_error::operator+=(const squared_error& other) {
  sum += other.sum;
  noise += other.noise;
  count += other.count;
  return *this;
}

double squared_error::rms() const {
  return std::sqrt(std::max(0.0, mean_square()));
}

double squared_error::rms_noise() const {
  if (count == 0) return 0.0;
  const double of_square = std::sqrt(noise) / static_cast<double>(count);
  return std::min(std::sqrt(of_square), of_square / std::max(2.0 * rms(), 1e-30));
}

region region_of(const picture& truth, std::size_t pixel) {
  const half_pixel& a = truth.halves[0][pixel];
  const half_pixel& b = truth.halves[1][pixel];
  if (a.entries == 0.0F && b.entries == 0.0F) return region::bare;
  if (truth.edge[pixel] != 0) return region::edge;
  return a.alpha + b.alpha > 1.8F ? region::dense : region::sparse;
}

frame_error compare(const frame::image& drawn, const picture& truth, glm::vec3 half_pixel::*part) {
  frame_error error;
  for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
    squared_error here;
    for (int c = 0; c < 3; ++c) {
      const double estimate = encode(static_cast<double>(drawn.pixels[i][c]));
      const auto a = static_cast<double>((truth.halves[0][i].*part)[c]);
      const auto b = static_cast<double>((truth.halves[1][i].*part)[c]);
      here.see(estimate, a, b);
      error.largest = std::max(error.largest, std::abs(estimate - 0.5 * (a + b)));
    }
    here.noise *= 3.0;  // the channels' noise is one
    error.all += here;
    error.in[static_cast<std::size_t>(region_of(truth, i))] += here;
  }
  return error;
}

}  // namespace pelage::truth
