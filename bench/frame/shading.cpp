// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading.hpp"

#include <pelage/composite/radiance.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace pelage::frame {

camera_film::camera_film(const raster& from, const scene& world, const shaded_fibres& shades, components shown,
                         bool antialias)
    : from_(from),
      world_(world),
      shades_(shades),
      shown_(shown),
      side_(antialias ? 3 : 1),
      picture_(from.from().width, from.from().height) {
  nearest_.resize(picture_.pixels.size());
  limit_.resize(picture_.pixels.size());
  sample_depth_.resize(static_cast<std::size_t>(side_ * side_) * limit_.size());
  tbb::parallel_for(0, picture_.height, [&](int y) {
    for (int x = 0; x < picture_.width; ++x)
      see_opaque(x, y);
  });
}

void camera_film::see_opaque(int x, int y) {
  const view& eye = from_.from();
  const int samples = side_ * side_;
  float* depth = sample_depth_.data() + static_cast<std::size_t>(samples) * index(x, y);
  glm::vec3 sum(0.0F);
  for (int s = 0; s < samples; ++s) {
    const view_ray ray = eye.ray(sample_position(x, y, s));
    const glm::vec3 origin = eye.eye + eye.direction_to_world(ray.origin);
    const glm::vec3 direction = eye.direction_to_world(ray.direction);
    const auto hit = world_.opaque.hit(origin, direction);
    depth[s] = hit ? hit->distance : std::numeric_limits<float>::infinity();
    const glm::vec3 far = world_.background(direction);
    sum += hit ? glm::mix(world_.solid_radiance(origin + hit->distance * direction, *hit), far, hit->haze) : far;
  }
  const auto [nearest, farthest] = std::minmax_element(depth, depth + samples);
  nearest_[index(x, y)] = *nearest;
  limit_[index(x, y)] = *farthest;
  picture_.at(x, y) = sum / static_cast<float>(samples);
}

std::size_t camera_film::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x);
}

glm::vec2 camera_film::sample_position(int x, int y, int sample) const {
  const glm::vec2 corner(static_cast<float>(x), static_cast<float>(y));
  const glm::vec2 inside(static_cast<float>(sample % side_) + 0.5F, static_cast<float>(sample / side_) + 0.5F);
  return corner + inside / static_cast<float>(side_);
}

float camera_film::visible_coverage(std::size_t pixel, const touch& where) const {
  if (where.depth < nearest_[pixel]) return where.coverage;
  const int samples = side_ * side_;
  const float* depth = sample_depth_.data() + static_cast<std::size_t>(samples) * pixel;
  const auto in_front = std::count_if(depth, depth + samples, [&](float d) { return where.depth < d; });
  return where.coverage * (static_cast<float>(in_front) / static_cast<float>(samples));
}

float camera_film::opacity(const seen_fragment& f) const {
  return has_translucency(shown_) ? from_.mix(from_.fibres().opacity, f.id, f.where.along) : 1.0F;
}

void camera_film::lose(int x, int y, std::span<const seen_fragment> lost, tail& behind) {
  const std::size_t pixel = index(x, y);
  for (const seen_fragment& f : lost)
    behind = add_fragment(behind, opacity(f) * visible_coverage(pixel, f.where), shades_.at(f.id, f.where.along));
}

void camera_film::finish(int x, int y, std::span<const seen_fragment> nearest, const tail& behind) {
  pixel_radiance<float> pixel = empty_pixel<float>();
  for (const seen_fragment& f : nearest) {
    pixel = add_fibre(pixel, shades_.at(f.id, f.where.along), glm::vec3(1.0F - opacity(f)),
                      visible_coverage(index(x, y), f.where));
  }
  pixel = add_fibre(pixel, mean_colour(behind), glm::vec3(transmittance_of(behind)), 1.0F);
  picture_.at(x, y) = resolve(pixel, behind_fibres(x, y));
}

void camera_film::look_at(int x, int y, std::span<const seen_fragment> all, std::vector<layer>& layers) const {
  layers.clear();
  for (const seen_fragment& f : all) {
    layers.push_back(
        {fragment_of(f), opacity(f) * visible_coverage(index(x, y), f.where), shades_.at(f.id, f.where.along)});
  }
}

}  // namespace pelage::frame
