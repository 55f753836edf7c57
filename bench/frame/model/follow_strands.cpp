// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/follow_strands.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "frame/base/random.hpp"

namespace pelage::frame {

namespace {

using glm::vec3;

constexpr float two_pi = 6.2831853F;

/// A polyline's points with unit vectors across it, carried along with as little twist as they can have.
struct guide_frame {
  vec3 point;
  vec3 side;
  vec3 up;
  float along;  ///< length from the root
};

std::vector<guide_frame> frames_along(const vec3* points, std::uint32_t count) {
  std::vector<guide_frame> frames(count);
  vec3 tangent(0.0F, 1.0F, 0.0F);
  vec3 side(0.0F);
  float along = 0.0F;
  for (std::uint32_t i = 0; i < count; ++i) {
    const vec3 step = points[std::min(i + 1, count - 1)] - points[i == 0 ? 0 : i - 1];
    const float length = glm::length(step);
    if (length > 0.0F && std::isfinite(length)) tangent = step / length;
    side -= tangent * glm::dot(side, tangent);
    if (glm::dot(side, side) < 1e-6F) {
      side = std::abs(tangent.x) < 0.7F ? vec3(1.0F, 0.0F, 0.0F) : vec3(0.0F, 1.0F, 0.0F);
      side -= tangent * glm::dot(side, tangent);
    }
    side = glm::normalize(side);
    if (i > 0) along += glm::length(points[i] - points[i - 1]);
    frames[i] = {points[i], side, glm::cross(tangent, side), along};
  }
  return frames;
}

/// How one follow strand stays beside its guide.
struct companion {
  float distance;  ///< at the root, in radii, [0, 0.85]
  float angle;
  float tip;    ///< factor of the distance at the tip
  float twist;  ///< turn round the guide from root to tip
  float waver;  ///< in radii
  float waver_turns;
  float waver_phase;
  float length;  ///< fraction of the guide's, [0.85, 1]

  explicit companion(random_stream& random)
      : distance(0.85F * std::sqrt(random.unit())),
        angle(random.between(0.0F, two_pi)),
        tip(random.between(0.15F, 0.55F)),
        twist(random.between(-0.9F, 0.9F)),
        waver(random.between(0.02F, 0.14F)),
        waver_turns(random.between(0.8F, 2.6F)),
        waver_phase(random.between(0.0F, two_pi)),
        length(random.between(0.85F, 1.0F)) {}

  /// Across the guide, in radii, at a fraction t of its length; no longer than 1.
  [[nodiscard]] glm::vec2 offset(float t) const {
    const float r = distance * (1.0F + (tip - 1.0F) * t * t * (3.0F - 2.0F * t));
    const float a = angle + twist * t;
    const float w = waver * t;
    const float b = two_pi * waver_turns * t + waver_phase;
    return {r * std::cos(a) + w * std::cos(b), r * std::sin(a) + w * std::sin(b)};
  }
};

}  // namespace

hair_model add_follow_strands(const hair_model& guides, std::uint32_t n, float radius, std::uint64_t seed) {
  if (!(radius >= 0.0F) || !std::isfinite(radius)) {
    throw std::invalid_argument("the radius of follow strands is not in [0, inf)");
  }
  const std::uint64_t copies = std::uint64_t{n} + 1;
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  if (guides.points.size() > most / copies || guides.strand_count() > most / copies) {
    throw std::length_error("the follow strands would have more than 2^32 - 1 points");
  }

  const std::size_t points = guides.points.size() * static_cast<std::size_t>(copies);
  hair_model out;
  out.default_thickness = guides.default_thickness;
  out.default_transparency = guides.default_transparency;
  out.default_colour = guides.default_colour;
  out.points.resize(points);
  if (!guides.thickness.empty()) out.thickness.resize(points);
  if (!guides.transparency.empty()) out.transparency.resize(points);
  if (!guides.colour.empty()) out.colour.resize(points);
  out.first_point.reserve(guides.strand_count() * static_cast<std::size_t>(copies) + 1);
  for (std::size_t g = 0; g < guides.strand_count(); ++g) {
    for (std::uint64_t c = 0; c < copies; ++c)
      out.first_point.push_back(out.first_point.back() + guides.point_count(g));
  }

  const auto follow = [&](std::size_t g) {
    const std::uint32_t count = guides.point_count(g);
    const std::size_t source = guides.first_point[g];
    const std::vector<guide_frame> frames = frames_along(guides.points.data() + source, count);
    const float whole = count > 0 ? frames.back().along : 0.0F;

    for (std::uint64_t c = 0; c < copies; ++c) {
      const std::size_t target = out.first_point[g * copies + c];
      random_stream random(seed, g * copies + c);
      const companion way(random);
      for (std::uint32_t i = 0; i < count; ++i) {
        if (!out.thickness.empty()) out.thickness[target + i] = guides.thickness[source + i];
        if (!out.transparency.empty()) out.transparency[target + i] = guides.transparency[source + i];
        if (!out.colour.empty()) out.colour[target + i] = guides.colour[source + i];
        if (c == 0 || count < 2) {
          out.points[target + i] = frames[i].point;
          continue;
        }
        const float x = static_cast<float>(i) * way.length;
        const std::uint32_t low = std::min(static_cast<std::uint32_t>(x), count - 2);
        const float f = x - static_cast<float>(low);
        const guide_frame& a = frames[low];
        const guide_frame& b = frames[low + 1];
        const float along = a.along + (b.along - a.along) * f;
        const glm::vec2 o = way.offset(whole > 0.0F ? along / whole : 0.0F) * radius;
        const vec3 side = glm::mix(a.side, b.side, f);
        const vec3 up = glm::mix(a.up, b.up, f);
        out.points[target + i] = glm::mix(a.point, b.point, f) + side * o.x + up * o.y;
      }
    }
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, guides.strand_count()),
                    [&](const tbb::blocked_range<std::size_t>& r) {
                      for (std::size_t g = r.begin(); g != r.end(); ++g)
                        follow(g);
                    });
  return out;
}

}  // namespace pelage::frame
