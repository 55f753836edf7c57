// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frame/on_device.hpp"

namespace pelage::test {

/// `antialias` divides pixels at opaque edges, where the processor has moments of the nearer part alone.
frame_settings frame_by(const std::string& shadow, const std::string& blend, bool antialias) {
  frame_settings s = small_frame();
  s.k = 8;
  s.shadow = parse_shadow(shadow);
  s.blend = parse_blend(blend);
  s.antialias = antialias;
  return s;
}

const std::vector<std::string> blends{"moments:4", "moments:6", "trigonometric:2", "trigonometric:3"};

TEST_CASE("Blended by moments, a device's picture is the processor's except for rounding") {
  std::vector<std::uint64_t> seen;
  for (const std::string& blend : blends) {
    for (const bool antialias : {false, true}) {
      CAPTURE(blend);
      CAPTURE(antialias);
      const frame_settings settings = frame_by("k_buffer", blend, antialias);
      const std::optional<device_frame> got = draw(settings);
      if (!got) return;
      const image here = drawn_here(settings).picture;
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
      frame_settings settings = frame_by(shadow, blend, true);
      const std::optional<device_frame> got = draw(settings, 2);
      if (!got) return;
      CHECK(got->same == got->frames);
      settings.shuffle = 5;
      CHECK(draw(settings)->hash == got->hash);
    }
  }
}

}  // namespace pelage::test
