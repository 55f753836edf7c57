// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "frame/vulkan/device_frame.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

#include "frame/model/built_in.hpp"

/// What the tests of pictures by a device share.
namespace pelage::test {

using namespace frame;

/// Hair so thick that no pixel of it keeps all its fragments at K = 4, and all do at K = 64.
inline const hair_model& small_hair() {
  static const hair_model model = make_built_in(150, 12, 1);
  return model;
}

/// Of that hair on its bust.
inline frame_settings small_frame() {
  frame_settings s;
  s.width = 56;
  s.height = 44;
  s.opacity = 0.4F;
  s.fibre_radius = 0.02F;
  s.on_bust = true;
  s.shading_spacing = std::numeric_limits<float>::infinity();  // as shaders light segments
  return s;
}

/// None, after one line, on a machine without a device, unless one is a must.
inline std::optional<device_frame> draw(const frame_settings& settings, std::uint32_t frames = 1,
                                        const hair_model& model = small_hair(), float degrees = 0.0F) {
  try {
    return draw_frame_on_device(model, settings, frames, degrees);
  } catch (const no_device& e) {
    MESSAGE("not run: ", e.what());
    CHECK(std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr);
    return std::nullopt;
  }
}

/// By the processor, of the last view that the camera turns to.
inline frame_result drawn_here(const frame_settings& settings, std::uint32_t frames = 1,
                               const hair_model& model = small_hair(), float degrees = 0.0F) {
  return draw_turn(model, settings, frames, degrees, [](const std::string&, double) {});
}

}  // namespace pelage::test
