// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "frame/fibres.hpp"
#include "frame/shadows/k_buffer_shadow.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

/// What the tests of shadow maps share: fibres in a light, and what passes them one by one.
namespace pelage::test {

inline constexpr int texels = 16;

/// A light that shines along -z on fibres round the origin, and on a ball now and then.
struct lit_fibres {
  frame::strands fibres =
      fibres_of(any_lines(10, glm::vec3(0.0F), 8.0F), any_float(0.05F, 1.0F), any_float(0.0F, 1.0F));
  frame::view light = flat_view(texels);
  frame::raster fragments{fibres, light, true};
  frame::solids opaque;

  lit_fibres() {
    if (*rc::gen::arbitrary<bool>()) opaque.parts.push_back({any_vec3(-4.0F, 4.0F), glm::vec3(any_float(1.0F, 4.0F))});
  }

  [[nodiscard]] frame::k_buffer_shadow map(frame::order_method method, std::uint32_t k) const {
    frame::k_buffer_shadow made(fragments, opaque);
    frame::run_order_pass(fragments, made.limit(), {method, k, {}}, made);
    return made;
  }

  /// The point at a depth on the ray through pixel coordinates.
  [[nodiscard]] glm::vec3 point(float x, float y, float depth) const {
    const frame::view_ray ray = light.ray(x, y);
    return light.eye + light.direction_to_world(ray.origin + depth * ray.direction);
  }
  [[nodiscard]] glm::vec3 centre(int x, int y, float depth) const {
    return point(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F, depth);
  }

  /// The depths of a texel's fragments in front of the ball, each with what passes the fragment.
  [[nodiscard]] std::vector<std::pair<float, double>> fragments_of(int x, int y, const frame::shadow_map& map) const {
    std::vector<std::pair<float, double>> found;
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      const frame::pixel_fragment f = fragments.at(s, x, y);
      if (f.coverage > 0.0F && f.depth < map.limit()[static_cast<std::size_t>(y * texels + x)]) {
        found.emplace_back(f.depth, 1.0 - static_cast<double>(fragments.mix(fibres.opacity, s, f.along) * f.coverage));
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }
};

inline double product(const std::vector<std::pair<float, double>>& fragments, float nearer_than) {
  double passed = 1.0;
  for (const auto& [depth, transmittance] : fragments)
    passed *= depth < nearer_than ? transmittance : 1.0;
  return passed;
}

/// A texel that has neighbours to the right and below, as the map reads four.
inline int any_texel() {
  return *rc::gen::inRange(0, texels - 1);
}

/// In steps that float subtracts without rounding.
inline float any_depth() {
  return static_cast<float>(*rc::gen::inRange(1, 4096)) / 128.0F;
}

}  // namespace pelage::test
