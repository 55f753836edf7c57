// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/fibres.hpp"
#include "frame/scene/lights.hpp"
#include "frame/shading/scene.hpp"
#include "frame/shadows/shadow_choice.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace pelage::test {

using namespace frame;

/// A light round the origin, and what its map lets through to fibres and objects.
struct shone_on {
  int texels = *rc::gen::element(16, 64, 256);
  sphere round{glm::vec3(0.0F), 1.0F};
  light source = any_light();
  view from = light_view(source, round, texels);

  /// Directional, or near enough that its rays spread by 20 degrees.
  static light any_light() {
    const bool parallel = *rc::gen::arbitrary<bool>();
    light l{};
    l.kind = parallel ? light_kind::directional : light_kind::point;
    const float height = any_float(-1.0F, 1.0F);
    const float turn = any_float(0.0F, 6.283F);
    const float level = std::sqrt(1.0F - height * height);
    l.position = 3.0F * glm::vec3(level * std::cos(turn), height, level * std::sin(turn));
    l.direction = -l.position / 3.0F;
    l.colour = glm::vec3(1.0F);
    return l;
  }

  /// A texel's width in the middle.
  [[nodiscard]] float texel() const { return from.pixel_at(from.to_view(round.centre)); }

  /// The transmittance to the middle of a segment, as scene::fibre_radiance() asks for it.
  [[nodiscard]] float passed(const strands& fibres, const std::string& method, std::uint32_t segment,
                             float along) const {
    const raster fragments(fibres, from, true);
    const cast_shadow made = cast(parse_shadow(method), fragments, {}, {order_method::k_buffer, 16, {}}, true);
    const glm::vec3 at = fibres.mix(fibres.point, segment, along);
    const glm::vec3 tangent = glm::normalize(fibres.mix(fibres.tangent, segment, along));
    const wide bias(2.0F * fibres.mix(fibres.radius, segment, along));
    return made.map->passed_to(made.map->find_on_fibres(filled<wide>(at), filled<wide>(tangent), bias, 1U))
        .transmittance.lane[0];
  }
};

std::string any_method() {
  return *rc::gen::element<std::string>("k_buffer", "exact", "deep:0", "occupancy", "deep_opacity:16");
}

TEST_CASE("A lone straight fibre does not shadow itself, up to 10 degrees to the light") {
  holds("any light, place, thickness and number of segments", [] {
    const shone_on lit;
    const float radius = lit.texel() * any_float(0.05F, 0.6F);
    const glm::vec3 root = any_vec3(-0.3F, 0.3F);
    const glm::vec3 way = any_vec3(-0.3F, 0.3F);
    RC_PRE(glm::length(way) > 0.05F);
    const glm::vec3 to_light = light_at(lit.source, lit.round, root).to_light;
    RC_PRE(glm::length(glm::cross(glm::normalize(way), to_light)) > 0.17F);
    const int segments = *rc::gen::inRange(1, 12);
    std::vector<glm::vec3> line;
    for (int i = 0; i <= segments; ++i)
      line.push_back(root + (static_cast<float>(i) / static_cast<float>(segments)) * way);
    const strands fibre = fibres_of({line}, radius, 0.9F);
    const auto segment = static_cast<std::uint32_t>(*rc::gen::inRange(0, segments));
    // A perspective map's slope is of first order: what it leaves out is below the thickness where texels are small.
    if (lit.from.perspective && lit.texels < 64) return;
    RC_ASSERT(lit.passed(fibre, any_method(), segment, any_float(0.0F, 1.0F)) == 1.0F);
  });
}

TEST_CASE("A fibre that crosses another's light a little more than its thickness before it does count") {
  holds("exact maps, any light and slope", [] {
    const shone_on lit;
    const float radius = lit.texel() * any_float(0.2F, 0.6F);
    const glm::vec3 place = any_vec3(-0.3F, 0.3F);
    const glm::vec3 to_light = light_at(lit.source, lit.round, place).to_light;
    const glm::vec3 way = any_vec3(-0.3F, 0.3F);
    RC_PRE(glm::length(way) > 0.05F);
    RC_PRE(glm::length(glm::cross(glm::normalize(way), to_light)) > 0.4F);
    if (lit.from.perspective && lit.texels < 64) return;
    const glm::vec3 nearer = 3.5F * radius * to_light;
    const strands two =
        fibres_of({{place - way, place + way}, {place - way + nearer, place + way + nearer}}, radius, 0.9F);
    const std::string method = *rc::gen::element<std::string>("k_buffer", "exact", "deep:0");
    RC_ASSERT(lit.passed(two, method, 0, any_float(0.4F, 0.6F)) < 0.95F);
    RC_ASSERT(lit.passed(two, method, 1, any_float(0.4F, 0.6F)) == 1.0F);
  });
}

TEST_CASE("A bare ball and floor have the light of their normals where they face it and nothing stands before") {
  holds("any light above the floor", [] {
    const shone_on lit;
    solids opaque;
    opaque.parts.push_back({any_vec3(-0.2F, 0.2F), glm::vec3(any_float(0.2F, 0.6F), any_float(0.2F, 0.6F), 0.5F)});
    opaque.floor = -0.9F;
    const strands none = fibres_of({}, 0.0F, 1.0F);
    const raster fragments(none, lit.from, true);
    scene with{none, opaque, {}, lit.round, glm::vec3(0.0F), fibre_bsdf({}, glm::vec3(0.5F))};
    scene without{none, opaque, {}, lit.round, glm::vec3(0.0F), fibre_bsdf({}, glm::vec3(0.5F))};
    cast_shadow made = cast(parse_shadow("exact"), fragments, opaque, {order_method::k_buffer, 16, {}}, true);
    with.lights.push_back({lit.source, std::move(made.map)});
    without.lights.push_back({lit.source, nullptr});
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::uniform_real_distribution<float> any(-0.8F, 0.8F);
    const glm::vec3 eye = 4.0F * glm::normalize(any_vec3(-1.0F, 1.0F) + glm::vec3(0.0F, 1.0F, 2.0F));
    for (int repeat = 0; repeat < 200; ++repeat) {
      const glm::vec3 toward = opaque.parts[0].centre + glm::vec3(any(random), any(random), any(random)) - eye;
      const wide_rays rays{filled<wide>(eye), filled<wide>(toward)};
      const solid_hit<float> hit = opaque.hit(eye, toward);
      if (std::isinf(hit.distance)) continue;
      const glm::vec3 at = eye + hit.distance * toward;
      const glm::vec3 to_light = light_at(lit.source, lit.round, at).to_light;
      if (glm::dot(hit.normal, to_light) < 0.01F) continue;
      const glm::vec3 seen = lane_of(with.seen_behind(rays).radiance, 0);
      const bool open = std::isinf(opaque.hit(at + 1e-3F * hit.normal, to_light).distance);
      if (open) RC_ASSERT(seen == lane_of(without.seen_behind(rays).radiance, 0));
      const bool shaded = !std::isinf(opaque.hit(at + 1e-2F * hit.normal, to_light).distance);
      if (shaded && lit.source.kind == light_kind::directional && hit.haze == 0.0F) RC_ASSERT(seen == glm::vec3(0.0F));
    }
  });
}

TEST_CASE("A free way ends at once for a direction into the object that the point lies on, and not for one out of it") {
  holds("ellipsoids and a floor", [] {
    solids s;
    s.parts.push_back({any_vec3(-1.0F, 1.0F), glm::vec3(any_float(0.2F, 1.0F), any_float(0.2F, 1.0F), 0.7F)});
    if (*rc::gen::arbitrary<bool>()) s.floor = -3.0F;
    const glm::vec3 from = s.parts[0].centre + 5.0F * glm::normalize(any_vec3(-1.0F, 1.0F) + glm::vec3(1e-3F));
    const glm::vec3 toward = s.parts[0].centre - from;
    const glm::vec3 at = from + s.hit(from, toward).distance * toward;
    const glm::vec3 direction = glm::normalize(any_vec3(-1.0F, 1.0F) + glm::vec3(1e-3F));
    const float facing = glm::dot(s.parts[0].normal(at), direction);
    RC_PRE(std::abs(facing) > 0.02F);
    const float way = s.free_way(at, direction);
    if (facing < 0.0F) RC_ASSERT(way < 0.01F);
    if (facing > 0.0F) RC_ASSERT(way > 1.0F);
    if (facing > 0.0F && !(direction.y < 0.0F && s.floor)) RC_ASSERT(std::isinf(way));
  });
}

}  // namespace pelage::test
