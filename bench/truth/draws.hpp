// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "frame/image/image.hpp"
#include "truth/lighting.hpp"

namespace pelage::truth {

/// A picture by stochastic transparency along rays, the cheapest way that is right on average: a sample is one ray
/// through the pixel, one of the fibres that it meets or what is behind them, and one shadow ray to each light that
/// either arrives or does not.
class drawn_by_rays {
 public:
  /// `scene` must outlive it.
  explicit drawn_by_rays(const lighting& scene);

  /// Adds some samples to every pixel, parallel over rows.
  void add(int samples);

  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] frame::image mean() const;

 private:
  [[nodiscard]] glm::dvec3 draw(const ray& through, frame::random_stream& random) const;

  const lighting& scene_;
  int samples_ = 0;
  std::uint64_t round_ = 0;
  std::vector<glm::dvec3> sum_;
};

}  // namespace pelage::truth
