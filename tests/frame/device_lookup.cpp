// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/device_frame.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#include "frame/model/built_in.hpp"

namespace pelage::test {

using namespace frame;

TEST_CASE("By jittered look-ups a device's picture is the processor's except for rounding, and no filtered one") {
  const hair_model hair = make_built_in(150, 12, 1);
  frame_settings settings;
  settings.width = 56;
  settings.height = 44;
  settings.k = 4;
  settings.opacity = 0.4F;
  settings.fibre_radius = 0.02F;
  settings.on_bust = true;
  settings.shading_spacing = std::numeric_limits<float>::infinity();  // as shaders light segments
  try {
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
      const device_frame got = draw_frame_on_device(hair, settings, 3);
      CHECK(got.same == got.frames);
      const image expected = draw_frame(hair, settings, [](const std::string&, double) {}).picture;
      CHECK(compare(got.picture, expected).rms < 0.0004);
      settings.lookup = map_lookup::filtered;
      CHECK(compare(draw_frame_on_device(hair, settings, 1).picture, expected).rms > 0.0006);
    }
  } catch (const no_device& e) {
    MESSAGE("not run: ", e.what());
    CHECK(std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr);
  }
}

}  // namespace pelage::test
