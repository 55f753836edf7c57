// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/draws.hpp"

#include "truth/camera.hpp"

namespace pelage::truth {

drawn_by_rays::drawn_by_rays(const lighting& scene)
    : scene_(scene),
      sum_(static_cast<std::size_t>(scene.set().eye.width) * static_cast<std::size_t>(scene.set().eye.height)) {
}

void drawn_by_rays::add(int samples) {
  constexpr std::uint64_t first_seed = 1000;  // the truth's rays are others
  const frame::view& eye = scene_.set().eye;
  for_each_pixel(eye, [&](int x, int y, std::size_t pixel) {
    pixel_rays rays(eye, x, y, first_seed + round_);
    for (int s = 0; s < samples; ++s)
      sum_[pixel] += draw(rays.next(), rays.random());
  });
  samples_ += samples;
  ++round_;
}

glm::dvec3 drawn_by_rays::draw(const ray& through, frame::random_stream& random) const {
  const frame::solids& opaque = scene_.set().opaque;
  const auto shadows = [&](const ray& way, std::uint32_t own) {
    return is_blocked(opaque, way) || scene_.fibres().draw_blocked(way, own, random) ? 0.0 : 1.0;
  };
  ray r = through;
  const opaque_hit behind = find_opaque(opaque, r);
  r.end = behind.distance;
  const auto hit = scene_.fibres().draw_nearest(r, random);
  return hit ? scene_.of(*hit, r, shadows).full : scene_.of(behind, r, shadows).full;
}

frame::image drawn_by_rays::mean() const {
  const frame::view& eye = scene_.set().eye;
  frame::image picture(eye.width, eye.height);
  for (std::size_t i = 0; i < sum_.size(); ++i)
    picture.pixels[i] = glm::vec3(sum_[i] / static_cast<double>(samples_));
  return picture;
}

}  // namespace pelage::truth
