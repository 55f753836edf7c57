// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// The share of a disc that a strip covers: any bits for the three lengths.
#include <pelage/coverage/disc_strip.hpp>

#include "../input.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

namespace {

using namespace pelage;

void check(float offset, float radius, float other_radius, float disc) {
  const float share = disc_strip_share(offset, radius, disc);
  fuzz::law(share >= 0.0f && share <= 1.0f, "a share is in [0, 1]");
  fuzz::law(share == disc_strip_share(-offset, radius, disc), "the two sides are alike");
  const float other = disc_strip_share(offset, other_radius, disc);
  const float thin = radius < other_radius ? share : other;
  const float wide = radius < other_radius ? other : share;
  // "Never falls when the fibre grows, save by that error", the error being 1e-6 of either share, where it is normal.
  const bool comparable = radius >= 0.0f && other_radius >= 0.0f;
  fuzz::law(!comparable || thin <= wide * 1.000003f + 4.0f * std::numeric_limits<float>::min(),
            "a wider fibre covers no less");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const auto offset = in.take<float>();
  const auto radius = in.take<float>();
  const auto other = in.take<float>();
  const auto disc = in.take<float>();
  check(offset, radius, other, disc);
  // The same within a few disc radii, where the strip's edges meet the disc's; random bits seldom are.
  const float nearby = in.unit() * 3.0f;
  check(nearby, in.unit() * 3.0f, in.unit() * 3.0f, 1.0f);
  const float thin = in.unit() * 1e-3f;
  check(nearby, thin, thin * (1.0f + in.unit()), 1.0f);
  check(1.0f - thin, thin, std::nextafter(thin, 1.0f), 1.0f);
  return 0;
}
