// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <tuple>

#include "frame/on_device.hpp"

namespace pelage::test {

frame_settings sliced_frame() {
  frame_settings s = small_frame();
  s.from = glm::vec2(20.0F, 5.0F);
  s.blend.method = blend_method::sliced;
  s.blend.size = 32;
  return s;
}

TEST_CASE("slices on a device are the processor's except for rounding, in any order of segments") {
  for (const shadow_method shadow : {shadow_method::k_buffer, shadow_method::occupancy}) {
    frame_settings settings = sliced_frame();
    settings.shadow.method = shadow;
    const std::optional<device_frame> got = draw(settings, 3);
    if (!got) return;
    CHECK(got->same == 3);
    CHECK(got->drawn.sorts == 1);
    CHECK(got->views.back().longest > 16);
    const image_difference d = compare(got->picture, drawn_here(settings).picture);
    CHECK(d.rms < 0.001);
    CHECK(d.maximum < 0.006);
    settings.shuffle = 5;
    CHECK(draw(settings)->hash == got->hash);
    settings.blend = {};
    settings.order = order_method::selection_sort;
    CHECK(draw(settings)->hash != got->hash);  // slices are not sorted lists
  }
}

TEST_CASE("a camera that turns on a device sees what it sees on the processor, and keeps the order as long") {
  frame_settings settings = sliced_frame();
  for (const auto& [frames, degrees, sorts] : {std::tuple{3U, 9.0F, 1U}, {3U, 10.0F, 2U}}) {
    const std::optional<device_frame> got = draw(settings, frames, small_hair(), degrees);
    if (!got) return;
    const frame_result expected = drawn_here(settings, frames, small_hair(), degrees);
    CHECK(got->drawn.sorts == sorts);
    CHECK(expected.drawn.sorts == sorts);
    CHECK(compare(got->picture, expected.picture).rms < 0.001);
  }
  settings.blend = {};
  const std::optional<device_frame> got = draw(settings, 2, small_hair(), 45.0F);
  CHECK(compare(got->picture, drawn_here(settings, 2, small_hair(), 45.0F).picture).rms < 0.001);
  CHECK(compare(got->picture, drawn_here(settings).picture).rms > 0.01);
}

TEST_CASE("lines on a device are the processor's except for rounding, which may move one by a pixel") {
  for (const bool antialias : {true, false}) {
    frame_settings settings = sliced_frame();
    settings.blend = {};
    settings.drawn = primitive::line;
    settings.antialias = antialias;
    const std::optional<device_frame> got = draw(settings, 2);
    if (!got) return;
    CHECK(got->same == 2);
    const image lines = drawn_here(settings).picture;
    CHECK(compare(got->picture, lines).rms < 0.002);
    settings.drawn = primitive::segment;
    CHECK(compare(drawn_here(settings).picture, lines).rms > 0.005);
  }
}

}  // namespace pelage::test
