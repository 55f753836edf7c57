// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/stage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include "frame/base/random.hpp"
#include "frame/base/stopwatch.hpp"
#include "frame/model/bust.hpp"
#include "frame/model/crowd.hpp"

namespace pelage::frame {
namespace {

constexpr float largest = 1e12F;  ///< lengths that a frame takes

bool is_sliced(const frame_settings& s) {
  return s.blend.method == blend_method::sliced || s.blend.method == blend_method::sliced_clipped;
}

void check(const frame_settings& s) {
  const auto in_range = [](int n) { return n >= 1 && n <= 16384; };
  if (!in_range(s.width) || !in_range(s.height))
    throw std::invalid_argument("the picture's sides must be in [1, 16384]");
  if (s.map_size != 0 && (s.map_size == 1 || !in_range(s.map_size))) {
    throw std::invalid_argument("the map's side must be 0 or in [2, 16384]");
  }
  if (!(s.shading_spacing >= 0.0F)) throw std::invalid_argument("the shading's spacing must be in [0, inf] pixels");
  if (s.opacity > 1.0F || std::isnan(s.opacity)) throw std::invalid_argument("alpha must be in [0, 1]");
  if (s.opacity >= 0.0F && s.look.passing == attenuation::fresnel) {
    throw std::invalid_argument("--alpha needs --attenuation constant");
  }
  if (s.from && !std::isfinite(s.from->x)) throw std::invalid_argument("the camera's azimuth must be finite");
  if (s.from && !(std::abs(s.from->y) < 90.0F)) {
    throw std::invalid_argument("the camera's elevation must be in (-90, 90) degrees");
  }
  for (const float channel : {s.ambient.r, s.ambient.g, s.ambient.b})
    if (!(channel >= 0.0F && channel <= 1e6F)) throw std::invalid_argument("ambient light must be in [0, 1e6]");
  if (!(s.sway >= 0.0F && s.sway <= 1.0F)) throw std::invalid_argument("--sway must be in [0, 1]");
  if (s.sway > 0.0F && is_sliced(s)) {
    throw std::invalid_argument("--sway: --blend sliced puts segments in slices once; hair that moves needs another");
  }
  if (!(s.distance >= 0.5F && s.distance <= 1000.0F)) {
    throw std::invalid_argument("the camera's distance must be in [0.5, 1000]");
  }
  for (const float error : {s.detail.segment, s.detail.strand})
    if (!(error >= 0.0F && error <= 64.0F)) throw std::invalid_argument("errors of detail must be in [0, 64] pixels");
  if (s.crowd < 1 || s.crowd > 4096) throw std::invalid_argument("a crowd has 1 to 4096 copies");
  if (!(s.fibre_radius <= largest)) throw std::invalid_argument("the fibre's radius must be at most 1e12");
}

/// Squares of what a frame computes with must stay in float's range.
void check(const hair_model& model, const box& bounds) {
  const auto too_large = [](float x) { return !(std::abs(x) <= largest); };
  if (bounds.empty()) return;
  for (const glm::vec3& corner : {bounds.lower, bounds.upper}) {
    if (too_large(corner.x) || too_large(corner.y) || too_large(corner.z)) {
      throw std::invalid_argument("the model reaches beyond 1e12 units");
    }
  }
  const float extent = glm::length(bounds.upper - bounds.lower);
  if (extent > 0.0F && extent < 1.0F / largest) throw std::invalid_argument("the model is smaller than 1e-12 units");
  if (too_large(model.default_thickness) || std::any_of(model.thickness.begin(), model.thickness.end(), too_large)) {
    throw std::invalid_argument("a fibre is thicker than 1e12 units");
  }
  const auto too_bright = [](const glm::vec3& c) { return !(std::max({c.x, c.y, c.z}) <= 1e6F); };
  if (too_bright(model.default_colour) || std::any_of(model.colour.begin(), model.colour.end(), too_bright)) {
    throw std::invalid_argument("a fibre's colour is brighter than 1e6");
  }
}

/// Every segment's number, in an order that depends on the seed alone.
std::vector<std::uint32_t> drawing_order(std::uint32_t segments, std::uint64_t seed) {
  if (seed == 0) return {};
  std::vector<std::uint32_t> order(segments);
  std::iota(order.begin(), order.end(), 0U);
  random_stream random(seed, 0);
  for (std::uint32_t i = segments; i > 1; --i)
    std::swap(order[i - 1], order[random.next() % i]);
  return order;
}

sphere sphere_round(const box& bounds) {
  if (bounds.empty()) return {glm::vec3(0.0F), 1.0F};
  const float radius = 0.5F * glm::length(bounds.upper - bounds.lower);
  return {0.5F * (bounds.lower + bounds.upper), radius > 0.0F ? radius : 1.0F};
}

solids opaque_objects(const hair_model& model, const box& bounds, bool on_bust) {
  solids s;
  if (on_bust) {
    s.parts.assign(bust.begin(), bust.end());
    s.floor = -2.75F;
  } else if (!bounds.empty()) {
    if (const auto head = fit_head(model)) s.parts.push_back(*head);
    float lowest = bounds.lower.y;
    for (const ellipsoid& part : s.parts)
      lowest = std::min(lowest, part.centre.y - part.radii.y);
    s.floor = lowest - 0.02F * (bounds.upper.y - bounds.lower.y);
  }
  return s;
}

/// Where the hair is seen best: from the front and a little aside, or from beside the middle of hair that grows on one
/// side of the head. Azimuth and elevation in degrees.
glm::vec2 best_side(const solids& opaque, const sphere& round, bool on_bust) {
  if (opaque.copies.size() > 1) return {0.0F, 24.0F};
  if (!on_bust && !opaque.parts.empty()) {
    const ellipsoid& head = opaque.parts.front();
    const glm::vec3 aside = round.centre - head.centre;
    if (std::hypot(aside.x, aside.z) > 0.25F * head.radii.x) {
      return {glm::degrees(std::atan2(aside.x, aside.z)) - 62.0F, 8.0F};
    }
  }
  return {23.0F, 8.0F};
}

glm::vec3 direction_of(const glm::vec2& azimuth_elevation) {
  const glm::vec2 a = glm::radians(azimuth_elevation);
  return {std::cos(a.y) * std::sin(a.x), std::sin(a.y), std::cos(a.y) * std::cos(a.x)};
}

/// A warm key from above the camera's right, and a cool rim from behind.
std::vector<light> studio(float camera_azimuth) {
  std::vector<light> lights{parse_light("spot:1.5,4.3,5.6:1.55,1.47,1.36:90"),
                            parse_light("directional:-0.9,1.3,-2.0:0.80,0.88,1.0")};
  const float turn = glm::radians(camera_azimuth);
  const glm::mat3 rotation(std::cos(turn), 0.0F, -std::sin(turn), 0.0F, 1.0F, 0.0F, std::sin(turn), 0.0F,
                           std::cos(turn));
  for (light& l : lights) {
    l.position = rotation * l.position;
    l.direction = rotation * l.direction;
  }
  return lights;
}

/// The camera in a direction from the fibres that sees the whole of their box.
view fitted_camera(const box& bounds, const sphere& round, const glm::vec3& toward, float away, int width, int height,
                   pixel_footprint footprint) {
  constexpr float tan_half_fov = 0.268F;  // 30 degrees
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const glm::vec3 half = bounds.empty() ? glm::vec3(1.0F) : 0.5F * (bounds.upper - bounds.lower);
  const glm::mat3 axes = perspective_view(toward, glm::vec3(0.0F), tan_half_fov, width, height, 0.0F).rotation;
  float distance = 1.01F * round.radius;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 sign((corner & 1) != 0 ? 1.0F : -1.0F, (corner & 2) != 0 ? 1.0F : -1.0F,
                         (corner & 4) != 0 ? 1.0F : -1.0F);
    const glm::vec3 c = sign * half;
    const glm::vec3 seen = axes * c;
    const float aside = std::max(std::abs(seen.x) / aspect, std::abs(seen.y));
    distance = std::max(distance, 1.02F * aside / tan_half_fov + glm::dot(c, toward));
  }
  distance *= away;
  return perspective_view(round.centre + distance * toward, round.centre, tan_half_fov, width, height,
                          0.01F * round.radius, footprint);
}

void place_views(stage& s, const frame_settings& settings) {
  s.from = settings.from ? *settings.from : best_side(s.opaque, s.round, settings.on_bust);
  const int texels =
      settings.map_size != 0 ? settings.map_size : std::clamp(std::max(settings.width, settings.height), 2, 2048);
  s.lights.clear();
  s.light_views.clear();
  for (const light& relative : settings.lights.empty() ? studio(s.from.x) : settings.lights) {
    s.lights.push_back(place_light(relative, s.round));
    s.light_views.push_back(light_view(s.lights.back(), s.round, texels));
  }
  s.eye = fitted_camera(s.bounds, s.round, direction_of(s.from), settings.distance, settings.width, settings.height,
                        settings.antialias ? settings.footprint : pixel_footprint::inscribed);
}

/// The strands as the views need them.
void choose_detail(stage& s, const frame_settings& settings) {
  stopwatch watch;
  std::vector<view> drawn{s.eye};
  if (has_shadows(settings.shown)) drawn.insert(drawn.end(), s.light_views.begin(), s.light_views.end());
  detailed_strands found =
      strands_in_detail(s.whole->fibres, s.whole->first_point, s.whole->copies, drawn, settings.detail);
  s.fibres = std::move(found.fibres);
  s.strand_count = found.count;
  s.drawing_order = drawing_order(s.fibres.segment_count(), settings.shuffle);
  s.slices.segments.clear();  // they are others
  s.detail_seconds += watch.lap();
}

/// What depends on where the views and the model's strands are: the strands that are drawn, and their slices.
void choose_strands(stage& s, const frame_settings& settings) {
  if (s.whole) choose_detail(s, settings);
  s.slices.slices = is_sliced(settings) ? settings.blend.size : 0;
  s.slices.update(s.fibres, s.bounds, -direction_of(s.from));
}

glm::vec3 mean(std::span<const glm::vec3> colours) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3& c : colours)
    sum += c;
  return sum / std::max(static_cast<double>(colours.size()), 1.0);
}

}  // namespace

stage set_up(const hair_model& model, const frame_settings& settings) {
  check(settings);
  check(model, model.bounds());
  stage s;
  s.hair = make_swaying(model, settings.sway);
  s.bounds = bounds_of(model, s.hair);
  s.opaque = opaque_objects(model, s.bounds, settings.on_bust);
  s.fibres = prepare_strands(model, {settings.fibre_radius, settings.opacity});
  s.strand_count = static_cast<std::uint32_t>(model.strand_count());
  sway(s.hair, 0, s.fibres);
  if (settings.crowd > 1) {
    const upright_bounds one = upright_bounds::of(model, s.hair, s.opaque.parts);
    const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
    s.opaque.set_copies(crowd_places(settings.crowd, one, aspect));
    s.bounds = crowd_bounds(s.opaque.copies, one);
    check(model, s.bounds);
  }
  if (settings.crowd > 1 || settings.detail.any()) {
    std::vector<placement> copies = s.opaque.copies;
    if (copies.empty()) copies.emplace_back();
    s.whole = whole_model{std::move(s.fibres), model.first_point, std::move(copies)};
  } else {
    s.drawing_order = drawing_order(s.fibres.segment_count(), settings.shuffle);
  }
  s.round = sphere_round(s.bounds);
  s.opaque.clear = 5.0F * s.round.radius;
  s.sky = glm::vec3(0.62F, 0.66F, 0.72F);
  place_views(s, settings);
  choose_strands(s, settings);
  return s;
}

line_depths line_depths_of(const stage& s, const view& from) {
  constexpr std::uint32_t bins = 256;
  strands ends;  // of all depths that moving hair may have
  if (s.hair.moves()) {
    const glm::vec3 back = s.round.radius * from.direction_to_world(glm::vec3(0.0F, 0.0F, 1.0F));
    ends.point = {s.round.centre + back, s.round.centre - back};
  }
  return line_depths_of(s.hair.moves() ? ends : s.fibres, from, &from == &s.eye ? bins : 0,
                        -from.to_view(s.round.centre).z);
}

void move_camera(stage& s, const frame_settings& settings) {
  check(settings);
  place_views(s, settings);
  choose_strands(s, settings);
}

void move_hair(stage& s, const frame_settings& settings, std::uint32_t frame) {
  if (!s.hair.moves()) return;
  sway(s.hair, frame, s.whole ? s.whole->fibres : s.fibres);
  choose_strands(s, settings);
}

drawn_report report_of(const stage& s) {
  return {s.strand_count, s.fibres.segment_count(), s.detail_seconds, s.slices.sorts, s.slices.sort_seconds};
}

fibre_bsdf make_bsdf(const stage& set, const fibre_look& look) {
  return {look, mean(set.whole ? set.whole->fibres.colour : set.fibres.colour)};
}

}  // namespace pelage::frame
