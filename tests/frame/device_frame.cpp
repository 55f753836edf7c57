// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "frame/fibres.hpp"
#include "frame/on_device.hpp"
#include "frame/order_methods.hpp"

namespace pelage::test {

frame_settings ordered_frame(order_method order, std::uint32_t k) {
  frame_settings s = small_frame();
  s.order = order;
  s.k = k;
  return s;
}

/// Why a frame is refused, or nothing.
std::string refusal(const frame_settings& settings, const hair_model& model = small_hair()) {
  try {
    (void)draw(settings, 1, model);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

TEST_CASE("A device's picture is the processor's except for rounding") {
  for (const components shown : {components::single, components::full}) {
    for (const bool antialias : {false, true}) {
      CAPTURE(static_cast<int>(shown));
      CAPTURE(antialias);
      frame_settings settings = ordered_frame(order_method::k_buffer, 8);
      settings.shown = shown;
      settings.antialias = antialias;
      const std::optional<device_frame> got = draw(settings);
      if (!got) return;
      const frame_result expected = drawn_here(settings);
      CHECK(compare(got->picture, expected.picture).rms < 0.001);
      CHECK(got->views.size() == expected.passes.size());
      for (std::size_t v = 0; v < got->views.size(); ++v) {
        const auto fragments = static_cast<double>(expected.passes[v].order.fragments);
        CHECK(static_cast<double>(got->views[v].offered) == doctest::Approx(fragments).epsilon(0.002));
        CHECK(got->views[v].refused == 0);
      }
    }
  }
}

TEST_CASE("Every structure draws one picture, in every frame") {
  std::optional<std::uint64_t> first;
  for (const order_method order : device_methods) {
    if (order == order_method::selection_sort) continue;  // it has no tail
    CAPTURE(static_cast<int>(order));
    const std::optional<device_frame> got = draw(ordered_frame(order, 4), 10);
    if (!got) return;
    CHECK(got->same == got->frames);
    if (!first) first = got->hash;
    CHECK(got->hash == *first);
  }
}

TEST_CASE("Truncated, every structure draws the processor's one picture, and what lies behind K is lost") {
  std::optional<std::uint64_t> first;
  for (const order_method order : device_methods) {
    if (order == order_method::selection_sort) continue;  // it loses nothing
    CAPTURE(static_cast<int>(order));
    frame_settings settings = ordered_frame(order, 4);
    settings.tails = 0;
    const std::optional<device_frame> got = draw(settings);
    if (!got) return;
    if (!first) {
      const frame_result expected = drawn_here(settings);
      CHECK(compare(got->picture, expected.picture).rms < 0.001);
      CHECK(compare(got->picture, draw(ordered_frame(order, 4))->picture).rms > 0.02);
      first = got->hash;
    }
    CHECK(got->hash == *first);
  }
}

TEST_CASE("Where K holds all fragments the picture is that of sorted lists") {
  const std::optional<device_frame> sorted = draw(ordered_frame(order_method::selection_sort, 64));
  if (!sorted) return;
  CHECK(sorted->hash == draw(ordered_frame(order_method::k_buffer, 64))->hash);
  CHECK(sorted->hash != draw(ordered_frame(order_method::k_buffer, 4))->hash);
}

constexpr blend_method without_lists[]{blend_method::order_weighted, blend_method::depth_peeling};

TEST_CASE("Blended and shadowed without lists, a device's picture is the processor's except for rounding") {
  for (const blend_method blend : without_lists) {
    for (const bool antialias : {false, true}) {
      CAPTURE(static_cast<int>(blend));
      CAPTURE(antialias);
      frame_settings settings = ordered_frame(order_method::k_buffer, 4);
      settings.blend.method = blend;
      settings.shadow.method = shadow_method::occupancy;
      settings.antialias = antialias;
      const std::optional<device_frame> got = draw(settings, 10);
      if (!got) return;
      CHECK(got->same == got->frames);
      const frame_result expected = drawn_here(settings);
      CHECK(compare(got->picture, expected.picture).rms < 0.001);
      settings.shuffle = 5;
      CHECK(draw(settings)->hash == got->hash);
    }
  }
}

TEST_CASE("A slab's sum stops at its end: 128 opaque fragments make it 2^32, and what lies behind stays hidden") {
  // Bars that fill the picture: 128 in the first of a pixel's four slabs, and a bright one in the last.
  const float apart = 1e-3F;
  std::vector<std::vector<glm::vec3>> bars(129, {{-2.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}});
  for (std::size_t i = 0; i < bars.size(); ++i) {
    for (glm::vec3& p : bars[i])
      p.z = -apart * static_cast<float>(i < 128 ? i : 1000);
  }
  hair_model model = model_of(bars, 1.5F, 1.0F);
  model.colour.assign(model.points.size(), glm::vec3(0.1F));
  model.colour.back() = glm::vec3(1.0F);
  frame_settings settings;
  settings.width = 24;
  settings.height = 24;
  settings.from = glm::vec2(0.0F);
  settings.shown = components::shadows;
  settings.shading_spacing = std::numeric_limits<float>::infinity();  // as a device has it
  settings.shadow.method = shadow_method::occupancy;
  settings.blend.method = blend_method::order_weighted;
  const std::optional<device_frame> got = draw(settings, 1, model);
  if (!got) return;
  const frame_result expected = drawn_here(settings, 1, model);
  CHECK(got->views.back().longest == 129);
  CHECK(compare(got->picture, expected.picture).rms < 0.001);
}

TEST_CASE("A light so near, and a map so coarse, that a texel's disc is wider than its ray is long") {
  frame_settings settings = ordered_frame(order_method::k_buffer, 4);
  settings.map_size = 2;
  settings.lights = {{light_kind::point, {0.0F, 0.0F, 1.05F}, glm::vec3(0.0F), glm::vec3(1.0F)}};
  const std::optional<device_frame> got = draw(settings);
  if (!got) return;
  const frame_result expected = drawn_here(settings);
  const auto fragments = static_cast<double>(expected.passes.front().order.fragments);
  CHECK(static_cast<double>(got->views.front().offered) == doctest::Approx(fragments).epsilon(0.002));
  CHECK(compare(got->picture, expected.picture).rms < 0.001);
}

TEST_CASE("Light beyond the range of a pixel's sums is clamped to its end") {
  frame_settings settings = ordered_frame(order_method::k_buffer, 4);
  settings.shown = components::translucency;
  settings.blend.method = blend_method::order_weighted;
  settings.lights = {{light_kind::directional, glm::vec3(0.0F), {0.0F, 0.0F, -1.0F}, glm::vec3(1e5F)}};
  const std::optional<device_frame> got = draw(settings);
  if (!got) return;
  const frame_result expected = drawn_here(settings);
  double sum = 0;
  for (std::size_t i = 0; i < expected.picture.pixels.size(); ++i) {
    const float right = expected.picture.pixels[i].r;
    sum += std::abs(got->picture.pixels[i].r - right) / (1.0F + right);
  }
  CHECK(sum / static_cast<double>(expected.picture.pixels.size()) < 0.001);
}

TEST_CASE("All layers peeled are the picture of sorted lists") {
  frame_settings settings = ordered_frame(order_method::selection_sort, 64);
  const std::optional<device_frame> sorted = draw(settings);
  if (!sorted) return;
  settings.blend.method = blend_method::depth_peeling;
  const std::optional<device_frame> peeled = draw(settings);
  CHECK(peeled->hash == sorted->hash);
  CHECK(peeled->views.back().longest == sorted->views.back().longest);
}

TEST_CASE("More layers than a frame has room for are refused, and said to be depth peeling's") {
  std::vector<std::vector<glm::vec3>> bars(2100, {{-1.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}});
  for (std::size_t i = 0; i < bars.size(); ++i) {
    for (glm::vec3& p : bars[i])
      p.z = -1e-4F * static_cast<float>(i);
  }
  frame_settings settings;
  settings.width = 8;
  settings.height = 8;
  settings.from = glm::vec2(0.0F);
  settings.shown = components::single;
  const hair_model model = model_of(bars, 0.1F, 0.01F);
  if (!draw(settings, 1, model)) return;
  settings.blend.method = blend_method::depth_peeling;
  CHECK(refusal(settings, model).find("--blend depth_peeling: 2100 layers") != std::string::npos);
}

TEST_CASE("Occupancy maps shadow pixels made in any way") {
  for (const blend_method blend : {blend_method::k_buffer, blend_method::order_weighted, blend_method::depth_peeling}) {
    CAPTURE(static_cast<int>(blend));
    frame_settings settings = ordered_frame(order_method::atomic_k_buffer, 64);
    settings.blend.method = blend;
    const std::optional<device_frame> by_lists = draw(settings);
    if (!by_lists) return;
    settings.shadow.method = shadow_method::occupancy;
    const double apart = compare(draw(settings)->picture, by_lists->picture).rms;
    CHECK(apart > 0.0);
    CHECK(apart < 0.02);
  }
}

TEST_CASE("The order of drawing does not change a device's picture") {
  frame_settings settings = ordered_frame(order_method::k_buffer, 4);
  const std::optional<device_frame> one = draw(settings);
  if (!one) return;
  settings.shuffle = 5;
  CHECK(draw(settings)->hash == one->hash);
}

TEST_CASE("What the shaders do not have is refused in one line") {
  frame_settings settings = ordered_frame(order_method::full_sort, 8);
  CHECK(refusal(settings).find("--order full_sort") != std::string::npos);
  settings = ordered_frame(order_method::k_buffer, 2);
  CHECK(refusal(settings).find("--k must be") != std::string::npos);
  settings = ordered_frame(order_method::k_buffer, 8);
  settings.shadow.method = shadow_method::deep;
  CHECK(refusal(settings).find("--shadow") != std::string::npos);
  settings = ordered_frame(order_method::k_buffer, 8);
  settings.blend.method = blend_method::stochastic;
  CHECK(refusal(settings).find("--blend") != std::string::npos);
  settings = ordered_frame(order_method::full_sort, 8);
  settings.blend.method = blend_method::order_weighted;
  CHECK(refusal(settings).find("--order full_sort") != std::string::npos);  // maps are made by it
  settings.shadow.method = shadow_method::occupancy;
  CHECK(refusal(settings).empty());  // nothing is
  for (const detail_errors errors : {detail_errors{0.0F, 0.0F}, {0.5F, 0.0F}, {0.0F, 0.5F}}) {
    settings = ordered_frame(order_method::k_buffer, 8);
    settings.sway = 0.1F;
    settings.detail = errors;
    settings.crowd = errors.any() ? 1 : 2;
    CHECK(refusal(settings).find("--device vulkan: --sway") != std::string::npos);
  }
}

TEST_CASE("a device draws fewer strands and segments, and a crowd, as the CPU does, from each place of a turn") {
  frame_settings settings = ordered_frame(order_method::k_buffer, 16);
  settings.detail = {0.5F, 0.8F};
  settings.crowd = 3;
  settings.from = glm::vec2(30.0F, 20.0F);
  frame_settings turned = settings;
  turned.from = glm::vec2(0.0F, 20.0F);
  const std::optional<device_frame> first = draw(settings);
  if (!first) return;
  const frame_result expected = drawn_here(settings);
  CHECK(first->drawn.strands == expected.drawn.strands);
  CHECK(first->drawn.segments == expected.drawn.segments);
  CHECK(first->drawn.segments < 3 * small_hair().segment_count());
  CHECK(compare(first->picture, expected.picture).rms < 0.0003);
  CHECK(same_bits(draw(turned, 3, small_hair(), 15.0F)->picture.pixels, first->picture.pixels));
}

TEST_CASE("a crowd that a device's constants do not hold is refused") {
  frame_settings settings = ordered_frame(order_method::k_buffer, 16);
  settings.crowd = 129;
  settings.detail.strand = 8.0F;
  CHECK(refusal(settings).find("a crowd of at most 128") != std::string::npos);
}

}  // namespace pelage::test
