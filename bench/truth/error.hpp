// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "truth/picture.hpp"

namespace pelage::truth {

/// A mean square of differences from the truth, the truth's noise taken out, which may leave less than 0.
struct squared_error {
  double sum = 0;
  double noise = 0;  ///< variance of the sum
  std::size_t count = 0;

  /// Adds pixels of one channel: an estimate, and the truth by both halves.
  void see(double estimate, double a, double b);
  squared_error& operator+=(const squared_error& other);

  [[nodiscard]] double mean_square() const { return count > 0 ? sum / static_cast<double>(count) : 0.0; }
  /// 0 where the noise leaves less.
  [[nodiscard]] double rms() const;
  /// The error of rms() that the rays' noise may make, one standard deviation.
  [[nodiscard]] double rms_noise() const;
};

/// Parts of a picture: each pixel is in one.
enum class region {
  bare,    ///< no ray met a fibre
  edge,    ///< fibres, and the edge of an opaque object
  dense,   ///< fibres hide more than 0.9
  sparse,  ///< fibres hide less
};
inline constexpr std::array<const char*, 4> region_names{"no hair", "an object's edge and hair", "alpha > 0.9",
                                                         "alpha < 0.9"};

[[nodiscard]] region region_of(const picture& truth, std::size_t pixel);

/// A frame against the truth.
struct frame_error {
  squared_error all;
  std::array<squared_error, region_names.size()> in;  ///< by region
  double largest = 0;                                 ///< difference from the mean of both halves

  [[nodiscard]] const squared_error& of(region r) const { return in[static_cast<std::size_t>(r)]; }
};

/// Compares sRGB values without rounding, with shadows (`half_pixel::full`) or without (`half_pixel::lit`).
[[nodiscard]] frame_error compare(const frame::image& drawn, const picture& truth, glm::vec3 half_pixel::*part);

}  // namespace pelage::truth
