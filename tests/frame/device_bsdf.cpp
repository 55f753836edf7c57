// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "frame/fibres.hpp"
#include "frame/on_device.hpp"

namespace pelage::test {

constexpr bsdf_model models[]{bsdf_model::kajiya_kay, bsdf_model::marschner, bsdf_model::chiang,
                              bsdf_model::dual_scattering};

/// Root mean square of what a device's channels may differ by from the processor's.
constexpr double rounding = 0.0003;

frame_settings lit_by(bsdf_model model, std::optional<melanin<float>> pigment = melanin_of<float>(hair_colour::blond)) {
  frame_settings s = small_frame();
  s.k = 8;
  s.look.model = model;
  s.look.pigment = pigment;
  return s;
}

TEST_CASE("Every model's picture, in every colour, is the processor's except for rounding") {
  std::vector<std::optional<melanin<float>>> pigments{std::nullopt};
  for (const hair_colour c : {hair_colour::blond, hair_colour::red, hair_colour::brown, hair_colour::black})
    pigments.emplace_back(melanin_of<float>(c));
  double worst = 0.0;
  for (const bsdf_model model : models) {
    for (const std::optional<melanin<float>>& pigment : pigments) {
      CAPTURE(static_cast<int>(model));
      CAPTURE(pigment ? pigment->eumelanin : -1.0F);
      const frame_settings settings = lit_by(model, pigment);
      const std::optional<device_frame> got = draw(settings);
      if (!got) return;
      const double apart = compare(got->picture, drawn_here(settings).picture).rms;
      CHECK(apart < rounding);
      worst = std::max(worst, apart);
    }
  }
  MESSAGE("largest difference: ", worst);
}

TEST_CASE("A fibre a little different differs by more than rounding") {
  for (const bsdf_model model : models) {
    if (model == bsdf_model::kajiya_kay) continue;  // of all this it has the pigment alone
    const frame_settings settings = lit_by(model);
    const image expected = drawn_here(settings).picture;
    std::vector<fibre_look> others(4, settings.look);
    others[0].eta += 0.05F;
    others[1].beta_m += 0.02F;
    others[2].tilt += 1.0F;
    others[3].pigment->eumelanin += 0.02F;
    if (model != bsdf_model::marschner) {
      others.push_back(settings.look);
      others.back().beta_n += 0.05F;
    }
    for (std::size_t i = 0; i < others.size(); ++i) {
      CAPTURE(static_cast<int>(model));
      CAPTURE(i);
      frame_settings other = settings;
      other.look = others[i];
      const std::optional<device_frame> got = draw(other);
      if (!got) return;
      CHECK(compare(got->picture, expected).rms > 2.0 * rounding);
    }
  }
}

/// The processor's picture, whatever else the settings say.
void check_picture(const frame_settings& settings) {
  const std::optional<device_frame> got = draw(settings);
  if (got) CHECK(compare(got->picture, drawn_here(settings).picture).rms < rounding);
}

TEST_CASE("Every model has the processor's shadows, whatever the maps keep, in filtered and in jittered look-ups") {
  for (const bsdf_model model : models) {
    for (const char* const shadow : {"k_buffer", "occupancy", "opacity:16", "deep_opacity:16"}) {
      CAPTURE(static_cast<int>(model));
      CAPTURE(shadow);
      frame_settings settings = lit_by(model);
      settings.shadow = parse_shadow(shadow);
      check_picture(settings);
      settings.lookup = map_lookup::jittered;
      check_picture(settings);
    }
  }
}

TEST_CASE("Every model's fibres blend in any way") {
  for (const bsdf_model model : models) {
    for (const blend_method blend : {blend_method::order_weighted, blend_method::depth_peeling}) {
      CAPTURE(static_cast<int>(model));
      CAPTURE(static_cast<int>(blend));
      frame_settings settings = lit_by(model);
      settings.blend.method = blend;
      check_picture(settings);
    }
  }
}

TEST_CASE("Without shadows, without translucency and by any lights") {
  for (const bsdf_model model : models) {
    for (const components shown : {components::single, components::shadows, components::translucency}) {
      CAPTURE(static_cast<int>(model));
      CAPTURE(static_cast<int>(shown));
      frame_settings settings = lit_by(model);
      settings.shown = shown;
      settings.lights = {{light_kind::point, {1.5F, 0.6F, 1.2F}, glm::vec3(0.0F), glm::vec3(0.7F)},
                         {light_kind::directional, glm::vec3(0.0F), {0.3F, -0.2F, 1.0F}, {0.5F, 0.4F, 0.3F}}};
      check_picture(settings);
    }
  }
}

TEST_CASE("Dual scattering's picture is the same for every structure, order of segments and frame") {
  std::optional<std::uint64_t> first;
  for (const order_method order :
       {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list, order_method::ordered_list,
        order_method::atomic_k_buffer, order_method::split_k_buffer}) {
    CAPTURE(static_cast<int>(order));
    frame_settings settings = lit_by(bsdf_model::dual_scattering);
    settings.order = order;
    settings.shuffle = static_cast<std::uint64_t>(order);
    const std::optional<device_frame> got = draw(settings, 5);
    if (!got) return;
    CHECK(got->same == got->frames);
    if (!first) first = got->hash;
    CHECK(got->hash == *first);
  }
}

TEST_CASE("A texel's count of fibres stops at 4096 and does not begin anew") {
  // Faint bars that fill the picture, lit through each other.
  std::vector<std::vector<glm::vec3>> bars(4300, {{-2.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}});
  for (std::size_t i = 0; i < bars.size(); ++i) {
    for (glm::vec3& p : bars[i])
      p.z = -1e-3F * static_cast<float>(i);
  }
  bars.push_back({{0.0F, -2.0F, 0.0F}, {0.0F, 2.0F, 0.0F}});  // so that the floor is far
  const hair_model model = model_of(bars, 0.5F, 2e-4F);
  for (const shadow_method shadow : {shadow_method::k_buffer, shadow_method::occupancy}) {
    CAPTURE(static_cast<int>(shadow));
    frame_settings settings;
    settings.width = 8;
    settings.height = 8;
    settings.map_size = 16;
    settings.from = glm::vec2(0.0F);
    settings.shading_spacing = std::numeric_limits<float>::infinity();
    settings.look.model = bsdf_model::dual_scattering;
    settings.look.pigment = melanin_of<float>(hair_colour::brown);
    settings.shadow.method = shadow;
    settings.lights = {{light_kind::directional, glm::vec3(0.0F), {0.0F, 0.0F, 1.0F}, glm::vec3(0.2F)}};
    const std::optional<device_frame> got = draw(settings, 1, model);
    if (!got) return;
    CHECK(compare(got->picture, drawn_here(settings, 1, model).picture).rms < rounding);
  }
}

TEST_CASE("A look out of its range is refused for every model") {
  for (const bsdf_model model : models) {
    frame_settings settings = lit_by(model);
    settings.look.eta = 0.5F;
    try {
      (void)draw(settings);
      CHECK(std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr);
    } catch (const std::invalid_argument& e) {
      CHECK(std::string(e.what()).find("index of refraction") != std::string::npos);
    }
  }
}

}  // namespace pelage::test
