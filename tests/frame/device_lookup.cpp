// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <utility>

#include "frame/on_device.hpp"

namespace pelage::test {

TEST_CASE("By jittered look-ups a device's picture is the processor's except for rounding, and no filtered one") {
  frame_settings settings = small_frame();
  settings.k = 4;
  for (const auto& maps_and_model : {std::pair{shadow_method::k_buffer, bsdf_model::kajiya_kay},
                                     std::pair{shadow_method::occupancy, bsdf_model::kajiya_kay},
                                     std::pair{shadow_method::k_buffer, bsdf_model::dual_scattering},
                                     std::pair{shadow_method::occupancy, bsdf_model::chiang}}) {
    const shadow_method shadow = maps_and_model.first;
    const bsdf_model model = maps_and_model.second;
    CAPTURE(static_cast<int>(shadow));
    CAPTURE(static_cast<int>(model));
    settings.shadow.method = shadow;
    settings.look.model = model;
    settings.lookup = map_lookup::jittered;
    const std::optional<device_frame> got = draw(settings, 3);
    if (!got) return;
    CHECK(got->same == got->frames);
    const image expected = drawn_here(settings).picture;
    CHECK(compare(got->picture, expected).rms < 0.0004);
    settings.lookup = map_lookup::filtered;
    CHECK(compare(draw(settings)->picture, expected).rms > 0.0006);
  }
}

}  // namespace pelage::test
