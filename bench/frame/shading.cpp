// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading.hpp"

#include <pelage/composite/radiance.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace pelage::frame {
namespace {

constexpr float sky_share = 0.30F;  ///< of the sky's light, what reaches every fibre through the others

view_ray centre_ray(const view& eye, int x, int y) {
  return eye.ray({static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
}

glm::vec3 toward_eye(const view& from, const view_ray& ray) {
  return -glm::normalize(from.direction_to_world(ray.direction));
}

}  // namespace

glm::vec3 scene::fibre_radiance(std::uint32_t segment, float along, const glm::vec3& to_eye) const {
  const auto at = [&](const auto& value) { return fibres.mix(value, segment, along); };
  const glm::vec3 position = at(fibres.point);
  const fibre_place place{glm::normalize(at(fibres.tangent)), to_eye, at(fibres.colour), at(fibres.opacity)};
  glm::vec3 sum = sky_share * sky * bsdf.reflect_sky(place);
  for (const lit& l : lights) {
    const arrival in = light_at(l.source, bounds, position);
    const passage passed = l.shadow
                               ? l.shadow->passed_to(position, 2.0F * at(fibres.radius) + l.shadow->texel_at(position))
                               : passage{1.0F, 0.0F, 1.0F};
    sum += in.colour * bsdf.scatter(place, in.to_light, passed);
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
      side_(antialias ? 3 : 1),
      picture_(from.from().width, from.from().height) {
  const std::size_t samples = static_cast<std::size_t>(side_ * side_);
  limit_.resize(picture_.pixels.size());
  sample_depth_.resize(samples * limit_.size());
  const view& eye = from_.from();
  tbb::parallel_for(0, picture_.height, [&](int y) {
    for (int x = 0; x < picture_.width; ++x) {
      float* depth = sample_depth_.data() + samples * index(x, y);
      for (int s = 0; s < side_ * side_; ++s)
        depth[s] = opaque_depth(eye, world_.opaque, sample_position(x, y, s));
      limit_[index(x, y)] = *std::max_element(depth, depth + samples);
    }
  });
}

std::size_t camera_film::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
}

glm::vec2 camera_film::sample_position(int x, int y, int sample) const {
  const glm::vec2 corner(static_cast<float>(x), static_cast<float>(y));
  const glm::vec2 inside(static_cast<float>(sample % side_) + 0.5F, static_cast<float>(sample / side_) + 0.5F);
  return corner + inside / static_cast<float>(side_);
}

float camera_film::visible_coverage(int x, int y, const touch& where) const {
  const int samples = side_ * side_;
  const float* depth = sample_depth_.data() + static_cast<std::size_t>(samples) * index(x, y);
  const auto in_front = std::count_if(depth, depth + samples, [&](float d) { return where.depth < d; });
  return where.coverage * (static_cast<float>(in_front) / static_cast<float>(samples));
}

float camera_film::opacity(const seen_fragment& f) const {
  return has_translucency(shown_) ? from_.mix(from_.fibres().opacity, f.id, f.where.along) : 1.0F;
}

glm::vec3 camera_film::radiance(const seen_fragment& f, const view_ray& ray) const {
  return world_.fibre_radiance(f.id, f.where.along, toward_eye(from_.from(), ray));
}

void camera_film::lose(int x, int y, std::span<const seen_fragment> lost, tail& behind) {
  const view_ray ray = centre_ray(from_.from(), x, y);
  for (const seen_fragment& f : lost)
    behind = add_fragment(behind, opacity(f) * visible_coverage(x, y, f.where), radiance(f, ray));
}

void camera_film::finish(int x, int y, std::span<const seen_fragment> nearest, const tail& behind) {
  const view_ray ray = centre_ray(from_.from(), x, y);
  pixel_radiance<float> pixel = empty_pixel<float>();
  for (const seen_fragment& f : nearest) {
    pixel = add_fibre(pixel, radiance(f, ray), glm::vec3(1.0F - opacity(f)), visible_coverage(x, y, f.where));
  }
  pixel = add_fibre(pixel, mean_colour(behind), glm::vec3(transmittance_of(behind)), 1.0F);
  picture_.at(x, y) = resolve(pixel, behind_fibres(x, y));
}

void camera_film::look_at(int x, int y, std::span<const seen_fragment> all, std::vector<layer>& layers) const {
  const view_ray ray = centre_ray(from_.from(), x, y);
  layers.clear();
  for (const seen_fragment& f : all)
    layers.push_back({fragment_of(f), opacity(f) * visible_coverage(x, y, f.where), radiance(f, ray)});
}

glm::vec3 camera_film::behind_fibres(int x, int y) const {
  const view& eye = from_.from();
  glm::vec3 sum(0.0F);
  for (int sample = 0; sample < side_ * side_; ++sample) {
    const glm::vec2 at = sample_position(x, y, sample);
    const view_ray ray = eye.ray(at);
    const glm::vec3 origin = eye.eye + eye.direction_to_world(ray.origin);
    const glm::vec3 direction = eye.direction_to_world(ray.direction);
    const auto hit = world_.opaque.hit(origin, direction);
    const glm::vec3 far = world_.background(direction);
    sum += hit ? glm::mix(world_.solid_radiance(origin + hit->distance * direction, *hit), far, hit->haze) : far;
  }
  return sum / static_cast<float>(side_ * side_);
}

}  // namespace pelage::frame
