// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/transmittance.hpp>

#include "property.hpp"
#include "sweep.hpp"

#include <glm/vec3.hpp>

#include <algorithm>

namespace pelage::test {

static_assert(transmittance(0.5f, 0.5f) == 0.75f);

/// Calls see(attenuation, coverage) evenly over [0, 1]², half of the points crowded at 0.
template <class See>
void for_each_fibre(See see) {
  for (int i = 0; i < 100'000; ++i) {
    const auto [u, v] = even_point<2>(i);
    see(static_cast<float>(u), static_cast<float>(v));
    see(static_cast<float>(on_log_scale(u, 1e-30, 1.0)), static_cast<float>(on_log_scale(v, 1e-30, 1.0)));
  }
}

TEST_CASE("transmittance is A C + (1 - C) within 1.2e-7, and in [0, 1]") {
  worst_case worst;
  bool in_range = true;
  for_each_fibre([&](float attenuation, float coverage) {
    const float passed = transmittance(attenuation, coverage);
    in_range = in_range && passed >= 0.0f && passed <= 1.0f;
    worst.see(std::abs(passed - (static_cast<double>(attenuation) * coverage + (1.0 - coverage))),
              {attenuation, coverage});
  });
  CHECK(in_range);
  CHECK_MESSAGE(worst.error < 1.2e-7, worst);
}

TEST_CASE("a clear fibre or one that covers nothing passes exactly all, one that covers all exactly A") {
  int wrong = 0;
  for_each_fibre([&](float attenuation, float coverage) {
    wrong += transmittance(1.0f, coverage) != 1.0f;
    wrong += transmittance(attenuation, 0.0f) != 1.0f;
    wrong += transmittance(attenuation, 1.0f) != attenuation;
  });
  CHECK(wrong == 0);
}

TEST_CASE("channels do not mix: three at once are three by themselves, bit for bit") {
  int wrong = 0;
  for_each_fibre([&](float attenuation, float coverage) {
    const glm::vec3 colour(attenuation, 0.5f * attenuation, 1.0f - attenuation);
    const glm::vec3 passed = transmittance(colour, coverage);
    for (int channel = 0; channel < 3; ++channel) {
      wrong += passed[channel] != transmittance(colour[channel], coverage);
    }
  });
  CHECK(wrong == 0);
}

}  // namespace pelage::test
