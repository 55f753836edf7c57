// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "frame/stage.hpp"

namespace pelage::frame {
namespace {

using clock = std::chrono::steady_clock;

double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

raster raster_of(const stage& set, const view& from, bool antialias, const frame_settings& settings) {
  const bool is_fresnel = settings.look.passing == attenuation::fresnel;
  const std::optional<float> eta = is_fresnel ? std::optional(settings.look.eta) : std::nullopt;
  if (settings.drawn == primitive::segment) return {set.fibres, from, antialias, eta};
  return {set.fibres, from, antialias, line_depths_of(set, from), eta};
}

}  // namespace

frame_result draw_frame(const hair_model& model, const frame_settings& settings,
                        const std::function<void(const std::string&, double)>& progress) {
  const clock::time_point start = clock::now();
  const stage set = set_up(model, settings);
  frame_result result = draw_frame(set, settings, progress);
  result.seconds = seconds_since(start);
  return result;
}

frame_result draw_frame(const stage& set, const frame_settings& settings,
                        const std::function<void(const std::string&, double)>& progress) {
  const clock::time_point start = clock::now();
  const strands& fibres = set.fibres;
  const order_options options{settings.order, settings.k, set.drawing_order};

  frame_result result;
  scene world{fibres, set.opaque, {}, set.round, set.sky, make_bsdf(set, settings.look), settings.lookup};
  world.ambient = settings.ambient;
  const double passes = static_cast<double>(set.lights.size() + 1);

  for (std::size_t i = 0; i < set.lights.size(); ++i) {
    lit l{set.lights[i], nullptr};
    if (has_shadows(settings.shown)) {
      const std::string name = fmt::format("light {}", i + 1);
      progress(name, static_cast<double>(i) / passes);
      const clock::time_point pass_start = clock::now();
      const raster fragments = raster_of(set, set.light_views[i], true, settings);
      const double prepared = seconds_since(pass_start);
      cast_shadow made = cast(settings.shadow, fragments, world.opaque, options, has_translucency(settings.shown));
      result.passes.push_back({name, prepared, made.report, made.map->bytes()});
      l.shadow = std::move(made.map);
    }
    world.lights.push_back(std::move(l));
  }

  progress("camera", static_cast<double>(set.lights.size()) / passes);
  const clock::time_point pass_start = clock::now();
  const raster fragments = raster_of(set, set.eye, settings.antialias, settings);
  const double prepared = seconds_since(pass_start);
  const backdrop behind(set.eye, world, settings.antialias);
  const shaded_fibres shades(world, fragments, behind.limit(), settings.shading_spacing);
  camera_film film(fragments, behind, shades, settings.shown, settings.tails);
  const double shaded = seconds_since(pass_start) - prepared;
  const order_report report = draw_on(film, settings.blend, fragments, options, set.slices);
  result.picture = film.picture();
  result.passes.push_back({"camera", prepared, report, result.picture.pixels.size() * sizeof(glm::vec3), shaded});
  result.seconds = seconds_since(start);
  result.drawn = report_of(set);
  progress("done", 1.0);
  return result;
}

frame_result draw_turn(const hair_model& model, const frame_settings& settings, std::uint32_t frames, float degrees,
                       const std::function<void(const std::string&, double)>& progress) {
  const clock::time_point start = clock::now();
  stage set = set_up(model, settings);
  frame_settings now = settings;
  const glm::vec2 first = set.from;
  if (frames > 1) move_hair(set, settings, frames - 1);
  for (std::uint32_t frame = 1; frame < frames && !set.hair.moves(); ++frame) {
    (void)draw_frame(set, now, progress);
    now.from = turned(first, degrees, frame);
    move_camera(set, now);
  }
  frame_result last = draw_frame(set, now, progress);
  last.seconds = seconds_since(start);
  return last;
}

}  // namespace pelage::frame
