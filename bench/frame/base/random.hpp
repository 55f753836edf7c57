// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace pelage::frame {

/// A stream of pseudo-random numbers that is a function of (seed, stream) alone: splitmix64 from a mixed
/// start.
///
/// Streams are independent enough for pictures, not for statistics or secrets. The same on every platform.
class random_stream {
 public:
  random_stream(std::uint64_t seed, std::uint64_t stream) : state_(mix(mix(seed + step) ^ (stream * step))) {}

  [[nodiscard]] std::uint64_t next() {
    state_ += step;
    return mix(state_);
  }

  /// Uniform in [0, 1), a multiple of 2^-24.
  [[nodiscard]] float unit() { return static_cast<float>(next() >> 40U) * 0x1p-24F; }

  /// Uniform in [lower, upper).
  [[nodiscard]] float between(float lower, float upper) { return lower + (upper - lower) * unit(); }

  /// Bell-shaped, mean 0, standard deviation 1, within [-3.47, 3.47]: a sum of four uniform numbers.
  [[nodiscard]] float bell() {
    float sum = unit();
    sum += unit();
    sum += unit();
    sum += unit();
    return (sum - 2.0F) * 1.7320508F;
  }

 private:
  static constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace pelage::frame
