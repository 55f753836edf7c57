// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// What passes fibres: as a product, and as a sum of optical depths.
#include <pelage/composite/optical_depth.hpp>
#include <pelage/composite/transmittance.hpp>

#include "../input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

using namespace pelage;

void check_single(float attenuation, float coverage) {
  const float passes = transmittance(attenuation, coverage);
  fuzz::law(passes >= 0.0f && passes <= 1.0f, "a transmittance is in [0, 1]");
  fuzz::law(transmittance(1.0f, coverage) == 1.0f, "a fibre that lets all pass changes nothing");
  fuzz::law(transmittance(attenuation, 0.0f) == 1.0f, "a fibre that covers nothing changes nothing");
  fuzz::law(transmittance(attenuation, 1.0f) == attenuation, "a fibre that covers all lets its attenuation pass");
}

void check_any(float alpha, float other) {
  const std::uint32_t depth = optical_depth(alpha);
  const std::uint32_t other_depth = optical_depth(other);
  fuzz::law(depth <= 32u << 20u, "one fragment counts at most 32 octaves");
  // fast_log2 rises except for its error, which is at most 1.5e-7 of 32 octaves, that is 6 units, both ways.
  fuzz::law(!(alpha < other) || depth <= other_depth + 11u, "more opacity, more optical depth");
  const float passes = transmittance_of(depth);
  fuzz::law(passes >= 0.0f && passes <= 1.0f, "an optical depth's transmittance is in [0, 1]");
}

/// The product of fragments against their sum in optical depth, within the error that the header states.
void check_sum(fuzz::input& in) {
  std::uint32_t sum = 0;
  double exact = 1.0;
  double octaves = 0.0;
  double error = 0.0;
  while (!in.empty() && octaves < 60.0) {
    const float alpha = std::min(in.unit(), 0.9999f);
    const double own = -std::log2(1.0 - static_cast<double>(1.0f - (1.0f - alpha)));
    sum = add_saturating(sum, optical_depth(alpha));
    exact *= static_cast<double>(1.0f - alpha);
    octaves += own;
    error += 0x1p-21 + 1.6e-7 * std::max(1.0, own);  // octaves
  }
  error += octaves * 0x1p-23;  // the sum as a float
  const double passes = static_cast<double>(transmittance_of(sum));
  fuzz::law(std::abs(passes / exact - 1.0) <= error * 0.6932 + 3e-7, "a sum of depths is a product of transmittances");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const auto alpha = in.take<float>();
  const auto other = in.take<float>();
  check_any(alpha, other);
  const float attenuation = in.unit();
  check_single(attenuation, in.unit());
  const auto a = in.take<std::uint32_t>();
  const auto b = in.take<std::uint32_t>();
  const auto c = in.take<std::uint32_t>();
  fuzz::law(add_saturating(a, add_saturating(b, c)) == add_saturating(add_saturating(c, a), b),
            "saturating sums come in any order");
  check_sum(in);
  return 0;
}
