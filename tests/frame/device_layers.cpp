// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frame/fibres.hpp"
#include "frame/on_device.hpp"

namespace pelage::test {

frame_settings frame_by(const std::string& shadow, const std::string& blend) {
  frame_settings s = small_frame();
  s.k = 8;
  s.shadow = parse_shadow(shadow);
  s.blend = parse_blend(blend);
  return s;
}

/// A device's picture is the processor's except for rounding, and every frame and order of drawing gives its bits.
void check_frame(frame_settings settings, const hair_model& model = small_hair()) {
  const std::optional<device_frame> got = draw(settings, 3, model);
  if (!got) return;
  CHECK(got->same == got->frames);
  CHECK(compare(got->picture, drawn_here(settings, 1, model).picture).rms < 0.001);
  settings.shuffle = 5;
  CHECK(draw(settings, 1, model)->hash == got->hash);
}

const std::vector<std::string> shadows{"opacity:4",       "opacity:32",     "opacity:128",
                                       "deep_opacity:4",  "deep_opacity:8", "deep_opacity_growing:8",
                                       "deep_opacity:256"};
const std::vector<std::string> blends{"weighted_average", "weighted_blended", "deep_opacity:4", "deep_opacity:32",
                                      "deep_opacity_corrected:32"};

TEST_CASE("Layered maps on a device shadow as the processor's do") {
  for (const std::string& shadow : shadows) {
    CAPTURE(shadow);
    check_frame(frame_by(shadow, "k_buffer"));
  }
}

TEST_CASE("Where the layers of lines begin is what lines reach, on a device as on the processor") {
  for (const char* shadow : {"deep_opacity:4", "deep_opacity_growing:4"}) {
    CAPTURE(shadow);
    frame_settings settings = frame_by(shadow, "k_buffer");
    settings.fibre_radius = 0.03F;
    settings.drawn = primitive::line;
    if (const auto got = draw(settings)) {
      CHECK(compare(got->picture, drawn_here(settings).picture).rms < 0.0004);
    }
  }
}

TEST_CASE("Blended without sorting, a device's picture is the processor's except for rounding") {
  for (const std::string& blend : blends) {
    for (const bool antialias : {false, true}) {
      CAPTURE(blend);
      CAPTURE(antialias);
      frame_settings settings = frame_by("k_buffer", blend);
      settings.antialias = antialias;
      check_frame(settings);
    }
  }
}

TEST_CASE("Layers of the lights and of the camera lie beside each other, and beside occupancy maps") {
  check_frame(frame_by("deep_opacity:16", "deep_opacity:32"));
  check_frame(frame_by("opacity:128", "weighted_average"));
  check_frame(frame_by("occupancy", "deep_opacity_corrected:8"));
  check_frame(frame_by("deep_opacity_growing:4", "order_weighted"));
  check_frame(frame_by("deep_opacity:4", "depth_peeling"));
  frame_settings settings = frame_by("deep_opacity:16", "deep_opacity:32");
  settings.shown = components::translucency;
  check_frame(settings);
  settings.shown = components::single;
  settings.antialias = false;  // at edges the processor has layers of the nearer part alone
  check_frame(settings);
}

TEST_CASE("Each of these methods has a picture of its own") {
  const std::optional<device_frame> first = draw(frame_by("k_buffer", "k_buffer"));
  if (!first) return;
  std::vector<std::uint64_t> seen{first->hash};
  const auto add = [&](const std::string& shadow, const std::string& blend) {
    CAPTURE(shadow);
    CAPTURE(blend);
    const std::uint64_t hash = draw(frame_by(shadow, blend))->hash;
    CHECK(std::find(seen.begin(), seen.end(), hash) == seen.end());
    seen.push_back(hash);
  };
  for (const char* shadow : {"opacity:8", "deep_opacity:8", "deep_opacity_growing:8"})
    add(shadow, "k_buffer");
  for (const char* blend :
       {"order_weighted", "weighted_average", "weighted_blended", "deep_opacity:8", "deep_opacity_corrected:8"})
    add("k_buffer", blend);
}

TEST_CASE("A layer's sum stops at its end: 128 opaque fragments make it 2^32, and what lies behind stays hidden") {
  // Bars that fill the picture: 128 in the first of a pixel's layers, and a bright one in the last.
  std::vector<std::vector<glm::vec3>> bars(129, {{-2.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}});
  for (std::size_t i = 0; i < bars.size(); ++i) {
    for (glm::vec3& p : bars[i])
      p.z = -1e-3F * static_cast<float>(i < 128 ? i : 1000);
  }
  hair_model model = model_of(bars, 1.5F, 1.0F);
  model.colour.assign(model.points.size(), glm::vec3(0.1F));
  model.colour.back() = glm::vec3(1.0F);
  const auto check = [&](const std::string& shadow, const std::string& blend) {
    CAPTURE(shadow);
    CAPTURE(blend);
    frame_settings settings = frame_by(shadow, blend);
    settings.width = settings.height = 24;
    settings.opacity = settings.fibre_radius = -1.0F;
    settings.on_bust = false;
    settings.from = glm::vec2(0.0F);
    settings.shown = components::shadows;
    check_frame(settings, model);
  };
  check("opacity:4", "deep_opacity:4");
  check("deep_opacity:4", "deep_opacity_corrected:4");
  check("deep_opacity_growing:4", "weighted_blended");
  check("deep_opacity:32", "weighted_average");
}

}  // namespace pelage::test
