// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <tuple>

#include "frame/fibres.hpp"
#include "frame/model/built_in.hpp"
#include "frame/vulkan/device_frame.hpp"

namespace pelage::test {

using namespace frame;

const hair_model& small_hair() {
  static const hair_model model = make_built_in(120, 12, 1);
  return model;
}

frame_settings small_frame() {
  frame_settings s;
  s.width = 56;
  s.height = 44;
  s.opacity = 0.4F;
  s.fibre_radius = 0.02F;
  s.on_bust = true;
  s.from = glm::vec2(20.0F, 5.0F);
  s.shading_spacing = std::numeric_limits<float>::infinity();  // as shaders light segments
  s.blend.method = blend_method::sliced;
  s.blend.size = 32;
  return s;
}

/// None, after one line, on a machine without a device, unless one is a must.
std::optional<device_frame> draw(const frame_settings& settings, std::uint32_t frames, float degrees = 0.0F) {
  try {
    return draw_frame_on_device(small_hair(), settings, frames, degrees);
  } catch (const no_device& e) {
    MESSAGE("not run: ", e.what());
    CHECK(std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr);
    return std::nullopt;
  }
}

frame_result on_processor(const frame_settings& settings, std::uint32_t frames = 1, float degrees = 0.0F) {
  return draw_turn(small_hair(), settings, frames, degrees, [](const std::string&, double) {});
}

TEST_CASE("slices on a device are the processor's except for rounding, in any order of segments") {
  for (const shadow_method shadow : {shadow_method::k_buffer, shadow_method::occupancy}) {
    frame_settings settings = small_frame();
    settings.shadow.method = shadow;
    const std::optional<device_frame> got = draw(settings, 3);
    if (!got) return;
    CHECK(got->same == 3);
    CHECK(got->sorts == 1);
    CHECK(got->views.back().longest > 16);
    const image_difference d = compare(got->picture, on_processor(settings).picture);
    CHECK(d.rms < 0.001);
    CHECK(d.maximum < 0.006);
    settings.shuffle = 5;
    CHECK(draw(settings, 1)->hash == got->hash);
    settings.blend = {};
    settings.order = order_method::selection_sort;
    CHECK(draw(settings, 1)->hash != got->hash);  // slices are not sorted lists
  }
}

TEST_CASE("a camera that turns on a device sees what it sees on the processor, and keeps the order as long") {
  frame_settings settings = small_frame();
  for (const auto& [frames, degrees, sorts] : {std::tuple{3U, 9.0F, 1U}, {3U, 10.0F, 2U}}) {
    const std::optional<device_frame> got = draw(settings, frames, degrees);
    if (!got) return;
    const frame_result expected = on_processor(settings, frames, degrees);
    CHECK(got->sorts == sorts);
    CHECK(expected.sorts == sorts);
    CHECK(compare(got->picture, expected.picture).rms < 0.001);
  }
  settings.blend = {};
  const std::optional<device_frame> got = draw(settings, 2, 45.0F);
  CHECK(compare(got->picture, on_processor(settings, 2, 45.0F).picture).rms < 0.001);
  CHECK(compare(got->picture, on_processor(settings).picture).rms > 0.01);
}

TEST_CASE("lines on a device are the processor's except for rounding, which may move one by a pixel") {
  for (const bool antialias : {true, false}) {
    frame_settings settings = small_frame();
    settings.blend = {};
    settings.drawn = primitive::line;
    settings.antialias = antialias;
    const std::optional<device_frame> got = draw(settings, 2);
    if (!got) return;
    CHECK(got->same == 2);
    const image lines = on_processor(settings).picture;
    CHECK(compare(got->picture, lines).rms < 0.002);
    settings.drawn = primitive::segment;
    CHECK(compare(on_processor(settings).picture, lines).rms > 0.005);
  }
}

}  // namespace pelage::test
