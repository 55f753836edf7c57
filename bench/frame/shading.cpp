// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading.hpp"

#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/composite/radiance.hpp>

#include <algorithm>

namespace pelage::frame {
namespace {

view_ray pixel_ray(const raster& from, float x, float y) { return from.from().ray({x, y}); }

glm::vec3 toward_eye(const view& from, const view_ray& ray) {
  return -glm::normalize(from.direction_to_world(ray.direction));
}

}  // namespace

glm::vec3 scene::fibre_radiance(std::uint32_t segment, float along, const glm::vec3& to_eye) const {
  const std::uint32_t i = fibres.segment[segment];
  const auto at = [&](const auto& value) { return value[i] + along * (value[i + 1] - value[i]); };
  const glm::vec3 position = at(fibres.point);
  const glm::vec3 tangent = glm::normalize(at(fibres.tangent));
  const glm::vec3 colour = at(fibres.colour);
  glm::vec3 sum = look.ambient * sky * colour;
  for (const lit& l : lights) {
    const arrival in = light_at(l.source, bounds, position);
    const float passed =
        l.shadow ? l.shadow->transmittance_to(position, 2.0F * at(fibres.radius) + l.shadow->texel_at(position)) : 1.0F;
    const kajiya_kay_lobes lobes = kajiya_kay(tangent, in.to_light, to_eye, look.exponent);
    sum += passed * in.colour * (look.diffuse * lobes.diffuse * colour + glm::vec3(look.specular * lobes.specular));
  }
  return sum;
}

glm::vec3 scene::solid_radiance(const glm::vec3& position, const solid_hit& hit) const {
  glm::vec3 sum = 0.5F * (1.0F + 0.3F * hit.normal.y) * sky;
  for (const lit& l : lights) {
    const arrival in = light_at(l.source, bounds, position);
    const float facing = glm::dot(hit.normal, in.to_light);
    if (facing <= 0.0F) continue;
    const float texel = l.shadow ? l.shadow->texel_at(position) : 0.0F;
    const glm::vec3 lifted = position + 2.0F * texel * hit.normal;
    const float passed = l.shadow ? l.shadow->transmittance_to(lifted, texel / std::max(facing, 0.2F)) : 1.0F;
    sum += passed * facing * in.colour;
  }
  return hit.colour * sum;
}

glm::vec3 scene::background(const glm::vec3& direction) const {
  const float up = 0.5F + 0.5F * glm::normalize(direction).y;
  return sky * glm::mix(glm::vec3(0.62F, 0.63F, 0.66F), glm::vec3(1.05F, 1.08F, 1.14F), up);
}

camera_film::camera_film(const raster& from, const scene& world, components shown, bool antialias)
    : from_(from),
      world_(world),
      shown_(shown),
      antialias_(antialias),
      picture_(from.from().width, from.from().height) {}

float camera_film::opacity(fragment f, const touch& where) const {
  return has_translucency(shown_) ? from_.mix(from_.fibres().opacity, f.id, where.along) : 1.0F;
}

glm::vec3 camera_film::radiance(fragment f, const touch& where, const view_ray& ray) const {
  return world_.fibre_radiance(f.id, where.along, toward_eye(from_.from(), ray));
}

void camera_film::lose(int x, int y, fragment lost, const touch& where, tail& behind) {
  const view_ray ray = pixel_ray(from_, static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  behind = add_fragment(behind, opacity(lost, where) * where.coverage, radiance(lost, where, ray));
}

void camera_film::finish(int x, int y, std::span<const fragment> nearest, const tail& behind) {
  const view_ray ray = pixel_ray(from_, static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  pixel_radiance<float> pixel = empty_pixel<float>();
  for (const fragment& f : nearest) {
    const touch where = from_.at(f.id, x, y);
    pixel = add_fibre(pixel, radiance(f, where, ray), glm::vec3(1.0F - opacity(f, where)), where.coverage);
  }
  pixel = add_fibre(pixel, mean_colour(behind), glm::vec3(transmittance_of(behind)), 1.0F);
  picture_.at(x, y) = resolve(pixel, behind_fibres(x, y));
}

glm::vec3 camera_film::behind_fibres(int x, int y) const {
  const int side = antialias_ ? 3 : 1;
  glm::vec3 sum(0.0F);
  for (int sample = 0; sample < side * side; ++sample) {
    const float dx = (static_cast<float>(sample % side) + 0.5F) / static_cast<float>(side);
    const float dy = (static_cast<float>(sample / side) + 0.5F) / static_cast<float>(side);
    const view& eye = from_.from();
    const view_ray ray = pixel_ray(from_, static_cast<float>(x) + dx, static_cast<float>(y) + dy);
    const glm::vec3 origin = eye.eye + eye.direction_to_world(ray.origin);
    const glm::vec3 direction = eye.direction_to_world(ray.direction);
    const auto hit = world_.opaque.hit(origin, direction);
    const glm::vec3 far = world_.background(direction);
    sum += hit ? glm::mix(world_.solid_radiance(origin + hit->distance * direction, *hit), far, hit->haze) : far;
  }
  return sum / static_cast<float>(side * side);
}

}  // namespace pelage::frame
