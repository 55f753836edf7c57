// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <optional>

#include "frame/on_device.hpp"

namespace pelage::test {

frame_settings fresnel_frame() {
  frame_settings s = small_frame();
  s.k = 4;
  s.opacity = -1.0F;  // the model's
  s.look.passing = attenuation::fresnel;
  return s;
}

TEST_CASE("By Fresnel's attenuation a device's picture is the processor's except for rounding") {
  for (const shadow_method shadow : {shadow_method::k_buffer, shadow_method::occupancy}) {
    for (const blend_method blend : {blend_method::k_buffer, blend_method::order_weighted}) {
      CAPTURE(static_cast<int>(shadow));
      CAPTURE(static_cast<int>(blend));
      frame_settings settings = fresnel_frame();
      settings.look.eta = 1.9F;
      settings.shadow.method = shadow;
      settings.blend.method = blend;
      const std::optional<device_frame> got = draw(settings, 3);
      if (!got) return;
      CHECK(got->same == got->frames);
      const image expected = drawn_here(settings).picture;
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
    frame_settings settings = fresnel_frame();
    settings.look.eta = 1.9F;
    settings.look.model = model;
    const std::optional<device_frame> got = draw(settings);
    if (!got) return;
    const image expected = drawn_here(settings).picture;
    CHECK(compare(got->picture, expected).rms < 0.001);
  }
}

TEST_CASE("By Fresnel's attenuation every structure draws one picture") {
  std::optional<std::uint64_t> first;
  for (const order_method order :
       {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list, order_method::ordered_list,
        order_method::atomic_k_buffer, order_method::split_k_buffer}) {
    CAPTURE(static_cast<int>(order));
    frame_settings settings = fresnel_frame();
    settings.order = order;
    const std::optional<device_frame> got = draw(settings);
    if (!got) return;
    if (!first) first = got->hash;
    CHECK(got->hash == *first);
  }
}

}  // namespace pelage::test
