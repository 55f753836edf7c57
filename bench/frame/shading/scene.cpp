// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/scene.hpp"

#include <pelage/core/mixed_bits.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>

namespace pelage::frame {
namespace {

constexpr float sky_share = 0.30F;  ///< of the sky's light, what reaches every fibre through the others

/// A place's own number, a strand's point having one for both of its segments.
std::uint32_t seed_of(const strands& fibres, std::uint32_t segment, float along) {
  const bool is_next = along == 1.0F;
  const std::uint32_t point = fibres.segment[segment] + (is_next ? 1U : 0U);
  return mixed_bits(point + mixed_bits(std::bit_cast<std::uint32_t>(is_next ? 0.0F : along)));
}

}  // namespace

/// As many places as there are lanes, and what they send to the eye.
struct scene::places {
  std::uint32_t set;
  wide3 position;
  wide radius;
  fibre_place_of<wide> fibre;
  wide3 sent;
  std::array<std::uint32_t, wide_width> seed;  ///< of the place, for jittered look-ups
  shadow_map::spots spots;                     ///< in the map of one light after the other
};

scene::places scene::places_at(std::span<const lit_place> at) const {
  wide3_builder position;
  wide3_builder tangent;
  wide3_builder colour;
  wide3_builder to_eye;
  wide3_builder opacity_and_radius;
  std::array<std::uint32_t, wide_width> seed{};
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto& [segment, along, eye] = at[i];
    const int k = static_cast<int>(i);
    position.set(k, fibres.mix(fibres.point, segment, along));
    tangent.set(k, fibres.mix(fibres.tangent, segment, along));
    colour.set(k, fibres.mix(fibres.colour, segment, along));
    to_eye.set(k, eye);
    if (lookup == map_lookup::jittered) seed[i] = seed_of(fibres, segment, along);
    opacity_and_radius.set(
        k, {fibres.mix(fibres.opacity, segment, along), fibres.mix(fibres.radius, segment, along), 0.0F});
  }
  const wide3 scalars = opacity_and_radius.done();
  return {(1U << at.size()) - 1U,
          position.done(),
          scalars.y,
          {unit_vector(tangent.done()), to_eye.done(), colour.done(), scalars.x},
          {},
          seed,
          {}};
}

void scene::fibre_radiance(std::span<const lit_place> asked, std::span<glm::vec3> radiance) const {
  constexpr std::size_t most = 4;  // groups whose texels are loaded together
  constexpr auto lanes_each = static_cast<std::size_t>(wide_width);
  std::array<places, most> groups;
  for (std::size_t begin = 0; begin < asked.size(); begin += most * lanes_each) {
    const std::span<const lit_place> some = asked.subspan(begin, std::min(most * lanes_each, asked.size() - begin));
    const std::span<places> here = std::span(groups).first((some.size() + lanes_each - 1) / lanes_each);
    for (std::size_t i = 0; i < here.size(); ++i) {
      const std::size_t first = i * lanes_each;
      here[i] = places_at(some.subspan(first, std::min(lanes_each, some.size() - first)));
      here[i].sent = filled<wide>(sky_share * sky + ambient) * bsdf.reflect_sky(here[i].fibre, here[i].set);
    }
    for (const lit& l : lights)
      light(l, here);
    for (std::size_t i = 0; i < some.size(); ++i)
      radiance[begin + i] = lane_of(here[i / lanes_each].sent, static_cast<int>(i % lanes_each));
  }
}

void scene::light(const lit& l, std::span<places> all) const {
  if (l.shadow) {
    for (places& p : all) {
      const wide width = wide(2.0F) * p.radius;
      p.spots = lookup == map_lookup::jittered
                    ? l.shadow->find_jittered_on_fibres(p.position, p.fibre.tangent, width, p.seed, p.set)
                    : l.shadow->find_on_fibres(p.position, p.fibre.tangent, width, p.set);
      l.shadow->prefetch(p.spots, 0);
    }
    for (const places& p : all)
      l.shadow->prefetch(p.spots, 1);
  }
  for (places& p : all) {
    const arrival_of<wide> in = light_at(l.source, bounds, p.position);
    const passage_of<wide> passed =
        l.shadow ? l.shadow->passed_to(p.spots) : passage_of<wide>{wide(1.0F), wide(0.0F), wide(1.0F)};
    p.sent = p.sent + in.colour * bsdf.scatter(p.fibre, in.to_light, passed, p.set);
  }
}

glm::vec3 scene::fibre_radiance(std::uint32_t segment, float along, const glm::vec3& to_eye) const {
  const lit_place place{segment, along, to_eye};
  glm::vec3 radiance;
  fibre_radiance(std::span(&place, 1), std::span(&radiance, 1));
  return radiance;
}

scene::backdrop_rays scene::seen_behind(const wide_rays& rays) const {
  const solid_hit<wide> hit = opaque.hit(rays.origin, rays.direction);
  const wide3 far = background(rays.direction);
  const auto solid = hit.distance < wide(std::numeric_limits<float>::infinity());
  if (!holds_for_any(solid)) return {hit.distance, far};
  const wide3 near = solid_radiance(rays.origin + hit.distance * rays.direction, hit, bits(solid));
  return {hit.distance, select(solid, near * (wide(1.0F) - hit.haze) + far * hit.haze, far)};
}

wide3 scene::solid_radiance(const wide3& position, const solid_hit<wide>& hit, std::uint32_t set) const {
  const wide zero(0.0F);
  wide3 sum = wide(0.5F) * (wide(1.0F) + wide(0.3F) * hit.normal.y) * filled<wide>(sky) + filled<wide>(ambient);
  for (const lit& l : lights) {
    const arrival_of<wide> in = light_at(l.source, bounds, position);
    const wide facing = dot_product(hit.normal, in.to_light);
    const std::uint32_t facing_lanes = set & bits(facing > zero);
    if (facing_lanes == 0) continue;
    wide passed(1.0F);
    if (l.shadow) {
      const auto open = distance_to(l.source, position) < opaque.free_way(position, in.to_light);
      const auto spots = l.shadow->find_on_surfaces(position, hit.normal, facing_lanes & bits(open));
      passed = select(open, l.shadow->passed_to(spots).transmittance, zero);
    }
    sum = sum + select(facing > zero, passed * facing * in.colour, wide3(zero));
  }
  return hit.colour * sum;
}

wide3 scene::background(const wide3& direction) const {
  const wide up = wide(0.5F) + wide(0.5F) * unit_vector(direction).y;
  const wide3 low = filled<wide>({0.62F, 0.63F, 0.66F});
  const wide3 high = filled<wide>({1.05F, 1.08F, 1.14F});
  return filled<wide>(sky) * (low * (wide(1.0F) - up) + high * up);
}

}  // namespace pelage::frame
