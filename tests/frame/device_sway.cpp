// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Hair that moves on a device.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "frame/fibres.hpp"
#include "frame/model/built_in.hpp"
#include "frame/vulkan/device_frame.hpp"
#include "frame/vulkan/session.hpp"

namespace pelage::test {

using namespace frame;

const hair_model& small_hair() {
  static const hair_model model = make_built_in(120, 12, 1);
  return model;
}

frame_settings small_frame(order_method order = order_method::k_buffer) {
  frame_settings s;
  s.width = 56;
  s.height = 44;
  s.k = 4;
  s.order = order;
  s.opacity = 0.4F;
  s.fibre_radius = 0.02F;
  s.on_bust = true;
  s.shading_spacing = std::numeric_limits<float>::infinity();  // as shaders light segments
  s.sway = 0.2F;
  return s;
}

/// None, after one line, on a machine without a device, unless one is a must.
std::optional<device_frame> draw(const frame_settings& settings, std::uint32_t frames,
                                 const hair_model& model = small_hair()) {
  try {
    return draw_frame_on_device(model, settings, frames);
  } catch (const no_device& e) {
    MESSAGE("not run: ", e.what());
    CHECK(std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr);
    return std::nullopt;
  }
}

image on_processor(const frame_settings& settings, std::uint32_t frames, const hair_model& model = small_hair()) {
  return draw_turn(model, settings, frames, 0.0F, [](const std::string&, double) {}).picture;
}

TEST_CASE(
    "a device moves points to where the processor does, within eight units in the last place of the model's size") {
  if (!draw(small_frame(), 1)) return;
  // The last strand's points lie on each other: its tangents are +y.
  hair_model model = make_built_in(120, 12, 1);
  model.points.insert(model.points.end(), 3, glm::vec3(0.5F));
  model.first_point.push_back(static_cast<std::uint32_t>(model.points.size()));
  for (const float amplitude : {0.05F, 0.3F, 1.0F}) {
    frame_settings settings = small_frame();
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
  frame_settings settings = small_frame();
  for (const attenuation passing : {attenuation::constant, attenuation::fresnel}) {
    settings.look.passing = passing;
    if (passing == attenuation::fresnel) settings.opacity = -1.0F;
    const std::optional<device_frame> got = draw(settings, 12);
    if (!got) return;
    CHECK(compare(got->picture, on_processor(settings, 12)).rms < 0.001);
    CHECK(compare(got->picture, on_processor(settings, 1)).rms > 0.005);
  }
}

TEST_CASE("moving hair is drawn twice as the same sequence, by each structure as by the others") {
  std::optional<std::uint64_t> first;
  for (const order_method order :
       {order_method::k_buffer, order_method::a_buffer, order_method::ordered_list, order_method::atomic_k_buffer,
        order_method::split_k_buffer, order_method::partial_selection_sort}) {
    CAPTURE(static_cast<int>(order));
    const std::optional<device_frame> got = draw(small_frame(order), 4);
    if (!got) return;
    CHECK(got->same == 4);
    if (!first) first = got->hash;
    CHECK(got->hash == *first);
    for (const device_frame::fragments& v : got->views)
      CHECK(v.refused == 0);
  }
  CHECK(draw(small_frame(), 3)->hash != *first);
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
    frame_settings settings = small_frame();
    settings.shadow = w.shadow;
    settings.blend = w.blend;
    settings.drawn = w.drawn;
    const std::optional<device_frame> got = draw(settings, 3);
    if (!got) return;
    CHECK(got->same == 3);
    CHECK(compare(got->picture, on_processor(settings, 3)).rms < w.rms);
  }
}

TEST_CASE("layers of depth are those of the first frame, and what moves beyond goes to the nearest") {
  for (const shadow_method method :
       {shadow_method::opacity, shadow_method::deep_opacity, shadow_method::deep_opacity_growing}) {
    CAPTURE(static_cast<int>(method));
    frame_settings settings = small_frame();
    settings.shadow.method = method;
    settings.shadow.layers = 16;
    const std::optional<device_frame> got = draw(settings, 12);
    if (!got) return;
    CHECK(got->same == 12);
    CHECK(compare(got->picture, on_processor(settings, 12)).rms < 0.01);
    CHECK(compare(draw(settings, 1)->picture, on_processor(settings, 1)).rms < 0.001);
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
  std::optional<std::uint64_t> first;
  for (const order_method order : {order_method::k_buffer, order_method::a_buffer}) {
    CAPTURE(static_cast<int>(order));
    frame_settings settings = small_frame(order);
    settings.on_bust = false;
    settings.from = glm::vec2(0.0F);
    settings.shown = components::translucency;
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
      CHECK(compare(got->picture, on_processor(settings, 8, model)).rms < 0.001);
    }
    CHECK(got->hash == *first);
    for (const device_frame::fragments& v : got->views)
      CHECK(v.refused == 0);
  }
}

}  // namespace pelage::test
