// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Hair that moves on a device.
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "frame/fibres.hpp"
#include "frame/on_device.hpp"
#include "frame/vulkan/session.hpp"

namespace pelage::test {

frame_settings swaying_frame(order_method order = order_method::k_buffer) {
  frame_settings s = small_frame();
  s.k = 4;
  s.order = order;
  s.sway = 0.2F;
  return s;
}

TEST_CASE(
    "a device moves points to where the processor does, within eight units in the last place of the model's size") {
  if (!draw(swaying_frame())) return;
  // The last strand's points lie on each other: its tangents are +y.
  hair_model model = small_hair();
  model.points.insert(model.points.end(), 3, glm::vec3(0.5F));
  model.first_point.push_back(static_cast<std::uint32_t>(model.points.size()));
  for (const float amplitude : {0.05F, 0.3F, 1.0F}) {
    frame_settings settings = swaying_frame();
    settings.sway = amplitude;
    stage set = set_up(model, settings);
    frame::vulkan::session on(set, settings);
    std::vector<glm::vec4> points(model.points.size());
    std::vector<glm::vec3> tangents(model.points.size());
    for (const std::uint32_t at : {0U, 7U, 50U, 99999U}) {
      CAPTURE(amplitude);
      CAPTURE(at);
      (void)on.draw(at);
      on.read_fibres(points, tangents);
      sway(set.hair, at, set.fibres);
      float most = 0.0F;
      float most_turned = 0.0F;
      for (std::size_t i = 0; i < points.size(); ++i) {
        most = std::max(most, glm::distance(glm::vec3(points[i]), set.fibres.point[i]));
        most_turned = std::max(most_turned, glm::distance(tangents[i], set.fibres.tangent[i]));
        CHECK(points[i].w == set.fibres.radius[i]);
      }
      CHECK(most < 8.0F * 0x1p-23F * set.round.radius);
      CHECK(most_turned < 2e-5F);
      CHECK(tangents.back() == glm::vec3(0.0F, 1.0F, 0.0F));
    }
  }
}

TEST_CASE("a frame of moving hair is the processor's except for rounding, and not the first one's") {
  frame_settings settings = swaying_frame();
  for (const attenuation passing : {attenuation::constant, attenuation::fresnel}) {
    settings.look.passing = passing;
    if (passing == attenuation::fresnel) settings.opacity = -1.0F;
    const std::optional<device_frame> got = draw(settings, 12);
    if (!got) return;
    CHECK(compare(got->picture, drawn_here(settings, 12).picture).rms < 0.001);
    CHECK(compare(got->picture, drawn_here(settings, 1).picture).rms > 0.005);
  }
}

TEST_CASE("moving hair is drawn twice as the same sequence, by each structure as by the others") {
  std::optional<std::uint64_t> first;
  for (const order_method order :
       {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list, order_method::ordered_list,
        order_method::atomic_k_buffer, order_method::split_k_buffer, order_method::partial_selection_sort}) {
    CAPTURE(static_cast<int>(order));
    const std::optional<device_frame> got = draw(swaying_frame(order), 4);
    if (!got) return;
    CHECK(got->same == 4);
    if (!first) first = got->hash;
    CHECK(got->hash == *first);
    for (const device_frame::fragments& v : got->views)
      CHECK(v.refused == 0);
  }
  CHECK(draw(swaying_frame(), 3)->hash != *first);
}

TEST_CASE("every way of light and of blending that a device has draws moving hair as the processor does") {
  struct way {
    shadow_choice shadow;
    blend_choice blend;
    primitive drawn = primitive::segment;
    double rms = 0.001;
  };
  const way ways[]{{{shadow_method::occupancy}, {blend_method::order_weighted}},
                   {{}, {blend_method::depth_peeling}},
                   {{}, {blend_method::weighted_average}},
                   {{}, {blend_method::moments, 4}, primitive::segment, 0.002},
                   {{}, {blend_method::deep_opacity, 8}},
                   {{}, {}, primitive::line, 0.002}};
  for (const way& w : ways) {
    CAPTURE(static_cast<int>(w.blend.method));
    frame_settings settings = swaying_frame();
    settings.shadow = w.shadow;
    settings.blend = w.blend;
    settings.drawn = w.drawn;
    const std::optional<device_frame> got = draw(settings, 3);
    if (!got) return;
    CHECK(got->same == 3);
    CHECK(compare(got->picture, drawn_here(settings, 3).picture).rms < w.rms);
  }
}

TEST_CASE("layers of depth are those of the first frame, and what moves beyond goes to the nearest") {
  for (const shadow_method method :
       {shadow_method::opacity, shadow_method::deep_opacity, shadow_method::deep_opacity_growing}) {
    CAPTURE(static_cast<int>(method));
    frame_settings settings = swaying_frame();
    settings.shadow.method = method;
    settings.shadow.layers = 16;
    const std::optional<device_frame> got = draw(settings, 12);
    if (!got) return;
    CHECK(got->same == 12);
    CHECK(compare(got->picture, drawn_here(settings, 12).picture).rms < 0.01);
    CHECK(compare(draw(settings, 1)->picture, drawn_here(settings, 1).picture).rms < 0.001);
  }
}

/// Strands that point at the camera while no gust meets them: a few pixels each. A gust bends them within a quarter of
/// a second.
hair_model end_on() {
  std::vector<std::vector<glm::vec3>> lines;
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 root(-1.242F, 0.702F, -0.907F);
    const glm::vec3 aside = 0.0005F * glm::vec3(i % 8, i / 8, 0);
    std::vector<glm::vec3> line;
    for (int p = 0; p <= 3; ++p)
      line.push_back(root + aside + glm::vec3(0.0F, 0.0F, static_cast<float>(p) / 3.0F));
    lines.push_back(line);
  }
  return model_of(lines, 0.004F, 0.3F);
}

TEST_CASE("hair that needs more room than its first frame did gets it, loses nothing, and is drawn the same") {
  const hair_model model = end_on();
  for (const components shown : {components::translucency, components::full}) {
    std::optional<std::uint64_t> first;
    for (const order_method order : {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list}) {
      CAPTURE(static_cast<int>(shown));
      CAPTURE(static_cast<int>(order));
      frame_settings settings = swaying_frame(order);
      settings.on_bust = false;
      settings.from = glm::vec2(0.0F);
      settings.shown = shown;
      settings.fibre_radius = -1.0F;
      settings.opacity = -1.0F;
      settings.sway = 1.0F;
      settings.width = 96;
      settings.height = 96;
      const std::optional<device_frame> got = draw(settings, 8, model);
      if (!got) return;
      CHECK(got->redrawn > 0);
      CHECK(got->same == 8);
      if (!first) {
        first = got->hash;
        CHECK(compare(got->picture, drawn_here(settings, 8, model).picture).rms < 0.001);
      }
      CHECK(got->hash == *first);
      for (const device_frame::fragments& v : got->views)
        CHECK(v.refused == 0);
    }
  }
}

}  // namespace pelage::test
