// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Deep shadow maps never leave their error: any depths in order, any opacities, any error.
#include <pelage/visibility/deep_shadow_map.hpp>

#include "visibility.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace {

using namespace pelage;
using fuzz::law;

struct step {
  float depth, alpha;
};

/// The product of what lies strictly before a depth.
double truth_at(const std::vector<step>& steps, float depth) {
  double passed = 1.0;
  for (const step& s : steps) {
    const double stopped = s.alpha > 0.0f ? std::min(static_cast<double>(s.alpha), 1.0) : 0.0;
    passed *= detail::clamped_depth(s.depth) < detail::clamped_depth(depth) ? 1.0 - stopped : 1.0;
  }
  return passed;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const float error = in.take<float>();
  std::vector<step> steps;
  for (std::uint32_t left = in.below(49); left > 0 && !in.empty(); --left) {
    const auto depth = in.take<float>();
    const float alpha = in.below(4) == 0 ? in.take<float>() : in.unit();
    if (depth == depth) {
      steps.push_back({depth, alpha});
    }
  }
  std::sort(steps.begin(), steps.end(), [](const step& a, const step& b) { return a.depth < b.depth; });
  std::vector<float> look_ups = fuzz::take_depths(in, 32);
  for (const step& s : steps) {
    look_ups.push_back(s.depth);
  }
  std::sort(look_ups.begin(), look_ups.end());

  std::vector<deep_shadow_vertex> vertices(2 * steps.size() + 1);
  span_vertex_storage storage{vertices};
  deep_shadow_builder builder = deep_shadow_builder::begin(1u, error);
  for (const step& s : steps) {
    builder.add(storage, s.depth, s.alpha);
  }
  builder.finish(storage);
  law(builder.count <= 2 * steps.size(), "two vertices a fragment suffice");

  const double allowed = std::max(error > 0.0f ? std::min(static_cast<double>(error), 1.0) : 0.0, 2e-7);
  float before = 1.0f;
  for (const float depth : look_ups) {
    const float passed = deep_shadow_at(storage, 1u, builder.count, depth);
    law(passed >= 0.0f && passed <= before, "transmittance falls in [0, 1]");
    const double truth = truth_at(steps, depth);
    law(static_cast<double>(passed) >= truth - allowed && static_cast<double>(passed) <= truth + allowed,
        "transmittance is within the error");
    before = passed;
  }
  return 0;
}
