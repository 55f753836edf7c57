// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>

#include "frame/on_device.hpp"

namespace pelage::test {

TEST_CASE("K_d, K_s, the exponent and ambient light are the same on a device and on the processor") {
  const frame_settings settings = small_frame();
  const std::optional<device_frame> plain = draw(settings);
  if (!plain) return;
  const auto set = [&](auto change) {
    frame_settings other = settings;
    change(other);
    const image got = draw(other)->picture;
    CHECK(compare(got, drawn_here(other).picture).rms < 0.001);
    CHECK(compare(got, plain->picture).rms > 0.002);
  };
  set([](frame_settings& s) { s.look.diffuse = 0.1F; });
  set([](frame_settings& s) { s.look.specular = 1.5F; });
  set([](frame_settings& s) { s.look.exponent = 3.0F; });
  set([](frame_settings& s) { s.ambient = {0.4F, 0.2F, 0.1F}; });
}

}  // namespace pelage::test
