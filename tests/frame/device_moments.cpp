// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "frame/fibres.hpp"
#include "frame/model/built_in.hpp"
#include "frame/vulkan/device_frame.hpp"

namespace pelage::test {

using namespace frame;

const hair_model& small_hair() {
  static const hair_model model = make_built_in(150, 12, 1);
  return model;
}

/// `antialias` divides pixels at opaque edges, where the processor has moments of the nearer part alone.
frame_settings small_frame(const std::string& shadow, const std::string& blend, bool antialias) {
  frame_settings s;
  s.width = 56;
  s.height = 44;
  s.k = 8;
  s.opacity = 0.4F;
  s.fibre_radius = 0.02F;
  s.on_bust = true;
  s.shading_spacing = std::numeric_limits<float>::infinity();  // as shaders light segments
  s.shadow = parse_shadow(shadow);
  s.blend = parse_blend(blend);
  s.antialias = antialias;
  return s;
}

/// None, after one line, on a machine without a device, unless one is a must.
std::optional<device_frame> draw(const frame_settings& settings, std::uint32_t frames) {
  try {
    return draw_frame_on_device(small_hair(), settings, frames);
  } catch (const no_device& e) {
    MESSAGE("not run: ", e.what());
    CHECK(std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr);
    return std::nullopt;
  }
}

const std::vector<std::string> blends{"moments:4", "moments:6", "trigonometric:2", "trigonometric:3"};

TEST_CASE("Blended by moments, a device's picture is the processor's except for rounding") {
  std::vector<std::uint64_t> seen;
  for (const std::string& blend : blends) {
    for (const bool antialias : {false, true}) {
      CAPTURE(blend);
      CAPTURE(antialias);
      const frame_settings settings = small_frame("k_buffer", blend, antialias);
      const std::optional<device_frame> got = draw(settings, 1);
      if (!got) return;
      const image here = draw_frame(small_hair(), settings, [](const std::string&, double) {}).picture;
      CHECK(compare(got->picture, here).rms < (antialias ? 0.002 : 0.001));
      CHECK(std::find(seen.begin(), seen.end(), got->hash) == seen.end());
      seen.push_back(got->hash);
    }
  }
}

TEST_CASE("Every frame and every order of drawing gives the same bits, beside occupancy maps of the lights, too") {
  for (const char* shadow : {"k_buffer", "occupancy"}) {
    for (const char* blend : {"moments:6", "trigonometric:2"}) {
      CAPTURE(shadow);
      CAPTURE(blend);
      frame_settings settings = small_frame(shadow, blend, true);
      const std::optional<device_frame> got = draw(settings, 2);
      if (!got) return;
      CHECK(got->same == got->frames);
      settings.shuffle = 5;
      CHECK(draw(settings, 1)->hash == got->hash);
    }
  }
}

}  // namespace pelage::test
