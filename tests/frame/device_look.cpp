// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/device_frame.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>
#include <optional>

#include "frame/model/built_in.hpp"

namespace pelage::test {

using namespace frame;

/// None, after one line, on a machine without a device, unless one is a must.
std::optional<device_frame> draw(const hair_model& model, const frame_settings& settings) {
  try {
    return draw_frame_on_device(model, settings, 1);
  } catch (const no_device& e) {
    MESSAGE("not run: ", e.what());
    CHECK(std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr);
    return std::nullopt;
  }
}

TEST_CASE("K_d, K_s, the exponent and ambient light are the same on a device and on the processor") {
  const hair_model model = make_built_in(150, 12, 1);
  frame_settings settings;
  settings.width = 56;
  settings.height = 44;
  settings.on_bust = true;
  settings.opacity = 0.4F;
  settings.fibre_radius = 0.02F;
  settings.shading_spacing = std::numeric_limits<float>::infinity();  // as shaders light segments
  const std::optional<device_frame> plain = draw(model, settings);
  if (!plain) return;
  const auto set = [&](auto change) {
    frame_settings other = settings;
    change(other);
    const image got = draw(model, other)->picture;
    const frame_result expected = draw_frame(model, other, [](const std::string&, double) {});
    CHECK(compare(got, expected.picture).rms < 0.001);
    CHECK(compare(got, plain->picture).rms > 0.002);
  };
  set([](frame_settings& s) { s.look.diffuse = 0.1F; });
  set([](frame_settings& s) { s.look.specular = 1.5F; });
  set([](frame_settings& s) { s.look.exponent = 3.0F; });
  set([](frame_settings& s) { s.ambient = {0.4F, 0.2F, 0.1F}; });
}

}  // namespace pelage::test
