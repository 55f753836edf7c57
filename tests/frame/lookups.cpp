// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/lit_fibres.hpp"

#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"

#include <pelage/visibility/lookup_jitter.hpp>

#include <array>
#include <cmath>
#include <string>

namespace pelage::test {

using namespace frame;

glm::vec3 unit(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0.01F ? v / length : glm::vec3(0.6F, 0.0F, 0.8F);
}

/// A place on a fibre in the light, and a map that holds all fragments.
struct lit_place_on_fibre {
  lit_fibres lit;
  k_buffer_shadow map = lit.map(order_method::full_sort, 16);
  float x = any_float(0.0F, static_cast<float>(texels));
  float y = any_float(0.0F, static_cast<float>(texels));
  float depth = any_depth();
  glm::vec3 tangent = unit(any_vec3(-1.0F, 1.0F));

  /// By one lane.
  [[nodiscard]] float filtered() const { return lane_of(map.find_on_fibres(place(), wide_tangent(), wide(0.0F), 1U)); }
  [[nodiscard]] float jittered(std::uint32_t seed) const {
    return lane_of(map.find_jittered_on_fibres(place(), wide_tangent(), wide(0.0F), {seed}, 1U));
  }

 private:
  [[nodiscard]] wide3 place() const { return filled<wide>(lit.point(x, y, depth)); }
  [[nodiscard]] wide3 wide_tangent() const { return filled<wide>(tangent); }
  [[nodiscard]] float lane_of(const shadow_map::spots& spots) const {
    return map.passed_to(spots).transmittance.lane[0];
  }
};

TEST_CASE("a jittered look-up lets through what its texel does, before the depth that the fibre has there") {
  holds("each of many seeds", [] {
    const lit_place_on_fibre at;
    const glm::vec3 tangent = at.lit.light.direction_to_view(at.tangent);
    const glm::vec2 on_screen(tangent);  // x to the right and y up
    const float run2 = glm::dot(on_screen, on_screen);
    RC_PRE(run2 > 0.01F);
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
      const glm::vec2 moved = glm::vec2(at.x, at.y) + lookup_jitter(seed);
      const auto texel_at = [](float c) { return std::min(std::max(static_cast<int>(std::floor(c)), 0), texels - 1); };
      const int x = texel_at(moved.x);
      const int y = texel_at(moved.y);
      const glm::vec2 way(static_cast<float>(x) + 0.5F - at.x, at.y - static_cast<float>(y) - 0.5F);
      const float there = at.depth - tangent.z * glm::dot(way, on_screen) / run2;
      const auto fragments = at.lit.fragments_of(x, y, at.map);
      const auto passed = [&](float before) {
        return before > at.map.limit()[static_cast<std::size_t>(y * texels + x)] ? 0.0 : product(fragments, before);
      };
      const auto found = static_cast<double>(at.jittered(seed));
      RC_ASSERT(found >= passed(there + 1e-3F) - 1e-4);
      RC_ASSERT(found <= passed(there - 1e-3F) + 1e-4);
    }
  });
}

TEST_CASE("the mean of many jittered look-ups is the filtered one") {
  holds("2,000 seeds", [] {
    const lit_place_on_fibre at;
    double sum = 0.0;
    constexpr std::uint32_t count = 2000;
    for (std::uint32_t seed = 0; seed < count; ++seed)
      sum += static_cast<double>(at.jittered(seed));
    RC_ASSERT(std::abs(sum / count - static_cast<double>(at.filtered())) < 0.06);  // five standard deviations at most
  });
}

TEST_CASE("a jittered frame has the same bits in every order, and not those of a filtered one") {
  const hair_model hair = make_built_in(200, 12, 1);
  frame_settings settings;
  settings.width = settings.height = 64;
  settings.k = 4;
  settings.fibre_radius = 0.02F;
  settings.opacity = 0.4F;
  settings.on_bust = true;
  const auto draw = [&](int threads) {
    return on_threads(threads, [&] { return draw_frame(hair, settings, [](const std::string&, double) {}).picture; });
  };
  for (const float spacing : {0.0F, 8.0F}) {
    CAPTURE(spacing);
    settings.shading_spacing = spacing;
    settings.lookup = map_lookup::filtered;
    const image filtered = draw(2);
    settings.lookup = map_lookup::jittered;
    const image first = draw(1);
    CHECK_FALSE(same_bits(first.pixels, filtered.pixels));
    CHECK(compare(first, filtered).rms < 0.02);
    for (const order_method order :
         {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list, order_method::ordered_list}) {
      settings.order = order;
      settings.shuffle += 1;
      CHECK(same_bits(draw(static_cast<int>(settings.shuffle % 4) + 1).pixels, first.pixels));
    }
  }
}

}  // namespace pelage::test
