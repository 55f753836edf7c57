// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/device_frame.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

#include "frame/model/built_in.hpp"

namespace pelage::test {

using namespace frame;

const hair_model& small_hair() {
  static const hair_model model = make_built_in(150, 12, 1);
  return model;
}

frame_settings small_frame() {
  frame_settings s;
  s.width = 56;
  s.height = 44;
  s.k = 4;
  s.fibre_radius = 0.02F;
  s.on_bust = true;
  s.shading_spacing = std::numeric_limits<float>::infinity();  // as shaders light segments
  s.look.passing = attenuation::fresnel;
  return s;
}

/// None, after one line, on a machine without a device, unless one is a must.
std::optional<device_frame> draw(const frame_settings& settings, std::uint32_t frames = 1) {
  try {
    return draw_frame_on_device(small_hair(), settings, frames);
  } catch (const no_device& e) {
    MESSAGE("not run: ", e.what());
    CHECK(std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr);
    return std::nullopt;
  }
}

TEST_CASE("By Fresnel's attenuation a device's picture is the processor's except for rounding") {
  for (const shadow_method shadow : {shadow_method::k_buffer, shadow_method::occupancy}) {
    for (const blend_method blend : {blend_method::k_buffer, blend_method::order_weighted}) {
      CAPTURE(static_cast<int>(shadow));
      CAPTURE(static_cast<int>(blend));
      frame_settings settings = small_frame();
      settings.look.eta = 1.9F;
      settings.shadow.method = shadow;
      settings.blend.method = blend;
      const std::optional<device_frame> got = draw(settings, 3);
      if (!got) return;
      CHECK(got->same == got->frames);
      const image expected = draw_frame(small_hair(), settings, [](const std::string&, double) {}).picture;
      CHECK(compare(got->picture, expected).rms < 0.001);
      settings.shuffle = 5;
      CHECK(draw(settings)->hash == got->hash);
      settings.look.eta = 1.55F;
      CHECK(compare(draw(settings)->picture, expected).rms > 0.003);
    }
  }
}

TEST_CASE("By Fresnel's attenuation each model of one scattering draws the processor's picture") {
  for (const bsdf_model model : {bsdf_model::marschner, bsdf_model::chiang}) {
    CAPTURE(static_cast<int>(model));
    frame_settings settings = small_frame();
    settings.look.eta = 1.9F;
    settings.look.model = model;
    const std::optional<device_frame> got = draw(settings);
    if (!got) return;
    const image expected = draw_frame(small_hair(), settings, [](const std::string&, double) {}).picture;
    CHECK(compare(got->picture, expected).rms < 0.001);
  }
}

TEST_CASE("By Fresnel's attenuation every structure draws one picture") {
  std::optional<std::uint64_t> first;
  for (const order_method order : {order_method::k_buffer, order_method::a_buffer, order_method::ordered_list,
                                   order_method::atomic_k_buffer, order_method::split_k_buffer}) {
    CAPTURE(static_cast<int>(order));
    frame_settings settings = small_frame();
    settings.order = order;
    const std::optional<device_frame> got = draw(settings);
    if (!got) return;
    if (!first) first = got->hash;
    CHECK(got->hash == *first);
  }
}

}  // namespace pelage::test
