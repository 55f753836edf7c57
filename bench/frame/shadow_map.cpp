// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadow_map.hpp"

#include <pelage/composite/optical_depth.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage::frame {

float opaque_depth(const view& from, const solids& opaque, const glm::vec2& pixel) {
  const view_ray ray = from.ray(pixel);
  const glm::vec3 origin = from.eye + from.direction_to_world(ray.origin);
  const auto hit = opaque.hit(origin, from.direction_to_world(ray.direction));
  return hit ? hit->distance : std::numeric_limits<float>::infinity();
}

std::vector<float> opaque_depths(const view& from, const solids& opaque) {
  const auto width = static_cast<std::size_t>(from.width);
  std::vector<float> depth(width * static_cast<std::size_t>(from.height));
  tbb::parallel_for(0, from.height, [&](int y) {
    for (int x = 0; x < from.width; ++x) {
      depth[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] =
          opaque_depth(from, opaque, {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
    }
  });
  return depth;
}

shadow_map::shadow_map(const raster& from, const solids& opaque, std::uint32_t k, bool translucent)
    : from_(from), translucent_(translucent), limit_(opaque_depths(from.from(), opaque)) {
  const std::vector<std::uint32_t> same(limit_.size(), k);
  expect(same);
  texel_.assign(limit_.size(), texel{0, 0, 0});
}

void shadow_map::expect(std::span<const std::uint32_t> fragments_per_pixel) {
  first_.resize(fragments_per_pixel.size());
  std::size_t total = 0;
  for (std::size_t t = 0; t < first_.size(); ++t) {
    first_[t] = total;
    total += fragments_per_pixel[t];
  }
  entry_.resize(total);
  entry_.shrink_to_fit();
}

float shadow_map::alpha(fragment f, const touch& where) const {
  const float opacity = translucent_ ? from_.mix(from_.fibres().opacity, f.id, where.along) : 1.0F;
  return opacity * where.coverage;
}

void shadow_map::lose(int x, int y, fragment lost, const touch& where, tail& behind) {
  behind.optical = add_saturating(behind.optical, optical_depth(alpha(lost, where)));
  texel& t = texel_[index(x, y)];
  t.farthest = std::max(t.farthest, lost.depth);
}

void shadow_map::finish(int x, int y, std::span<const fragment> nearest, const tail& behind) {
  texel& t = texel_[index(x, y)];
  t.count = static_cast<std::uint32_t>(nearest.size());
  t.behind = behind.optical;
  std::uint32_t optical = 0;
  entry* out = entry_.data() + first_[index(x, y)];
  for (const fragment& f : nearest) {
    optical = add_saturating(optical, optical_depth(alpha(f, from_.at(f.id, x, y))));
    *out++ = entry{f.depth, optical};
  }
}

float shadow_map::transmittance_in(std::size_t t, float depth) const {
  const texel& here = texel_[t];
  const entry* begin = entry_.data() + first_[t];
  const entry* end = begin + here.count;
  const bool behind_all = here.count > 0 && end[-1].depth < depth;
  const entry* after =
      behind_all ? end : std::partition_point(begin, end, [depth](const entry& e) { return e.depth < depth; });
  std::uint32_t optical = after == begin ? 0 : after[-1].optical;
  if (after == end && here.behind > 0) {
    const float from = here.count > 0 ? end[-1].depth : 0.0F;
    const float span = here.farthest - from;
    const float share = span > 0.0F ? saturate((depth - from) / span) : 1.0F;
    const float behind = std::min(static_cast<float>(here.behind), 4294967040.0F);  // the last float below 2^32
    optical = add_saturating(optical, static_cast<std::uint32_t>(share * behind));
  }
  return transmittance_of(optical);
}

float shadow_map::transmittance_to(const glm::vec3& world, float bias) const {
  const view& light = from_.from();
  const glm::vec3 p = light.to_view(world);
  const float depth = -p.z - bias;
  if (depth <= light.near_plane) return 1.0F;
  const glm::vec2 pixel = light.to_pixel(p) - 0.5F;
  const glm::vec2 corner = glm::floor(pixel);
  const glm::vec2 weight = pixel - corner;
  if (!(corner.x >= 0.0F && corner.y >= 0.0F && corner.x < static_cast<float>(light.width - 1) &&
        corner.y < static_cast<float>(light.height - 1))) {
    return 1.0F;
  }
  const int x = static_cast<int>(corner.x);
  const int y = static_cast<int>(corner.y);
  const auto through = [&](int dx, int dy) {
    const std::size_t t = index(x + dx, y + dy);
    return depth > limit_[t] ? 0.0F : transmittance_in(t, depth);
  };
  const float top = glm::mix(through(0, 0), through(1, 0), weight.x);
  const float bottom = glm::mix(through(0, 1), through(1, 1), weight.x);
  return glm::mix(top, bottom, weight.y);
}

float shadow_map::texel_at(const glm::vec3& world) const {
  return 2.0F * radius_at(from_.from().cone, -from_.from().to_view(world).z);
}

std::uint64_t shadow_map::bytes() const {
  return first_.size() * sizeof(std::size_t) + texel_.size() * sizeof(texel) + entry_.size() * sizeof(entry) +
         limit_.size() * sizeof(float);
}

}  // namespace pelage::frame
