// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/picture.hpp"

#include <algorithm>
#include <cmath>

#include "truth/camera.hpp"

namespace pelage::truth {
namespace {

/// The encoding's second derivative.
double curvature(double linear) {
  if (linear <= 0.0031308 || linear >= 1.0) return 0.0;
  return 1.055 / 2.4 * (1.0 / 2.4 - 1.0) * std::pow(linear, 1.0 / 2.4 - 2.0);
}

/// Mean and variance of many colours.
class colour_sum {
 public:
  void see(const glm::dvec3& colour) {
    sum_ += colour;
    squares_ += colour * colour;
    ++count_;
  }
  [[nodiscard]] glm::dvec3 mean() const { return sum_ / static_cast<double>(count_); }
  [[nodiscard]] glm::vec3 encoded() const {
    const glm::dvec3 m = mean();
    const double n = count_;
    glm::vec3 value;
    for (int c = 0; c < 3; ++c) {
      const double variance_of_mean = std::max(0.0, squares_[c] / n - m[c] * m[c]) / (n - 1.0);
      value[c] = static_cast<float>(encode(m[c]) - 0.5 * curvature(m[c]) * variance_of_mean);
    }
    return value;
  }

 private:
  glm::dvec3 sum_{0.0};
  glm::dvec3 squares_{0.0};
  int count_ = 0;
};

/// The opaque objects that a pixel's rays meet.
class edge_finder {
 public:
  explicit edge_finder(const frame::stage& set)
      : bodies_(static_cast<int>(set.opaque.parts.size())), gap_(0.05 * static_cast<double>(set.round.radius)) {}

  void see(const opaque_hit& h) {
    if (h.object < 0 || h.object >= bodies_) {
      beside_ = true;
      return;
    }
    nearest_ = std::min(nearest_, h.distance);
    farthest_ = std::max(farthest_, h.distance);
  }
  /// A body and what is not a body, or two depths of bodies.
  [[nodiscard]] bool found() const { return farthest_ > 0.0 && (beside_ || farthest_ - nearest_ > gap_); }

 private:
  int bodies_;
  double gap_;
  double nearest_ = std::numeric_limits<double>::infinity();
  double farthest_ = 0;
  bool beside_ = false;
};

struct ray_sum {
  radiance colour;
  double alpha = 0;
};

/// All fibres before the opaque object, nearest first, then the object or the background.
ray_sum look_along(const lighting& scene, const ray& r, const opaque_hit& behind, const std::vector<fibre_hit>& met,
                   frame::random_stream& random) {
  const auto shadows = [&](const ray& way, std::uint32_t own) { return scene.passing(way, own); };
  ray_sum sum;
  double passed = 1;  // of what lies behind
  double weight = 1;  // the same as an estimate
  for (const fibre_hit& h : met) {
    const auto alpha = static_cast<double>(scene.fibres().opacity(h));
    passed *= 1.0 - alpha;
    if (weight == 0.0) continue;
    if (weight < 0.2) weight = random.unit() < 0.5F ? 0.0 : 2.0 * weight;
    if (weight * alpha > 0.0) sum.colour += weight * alpha * scene.of(h, r, shadows);
    weight *= 1.0 - alpha;
  }
  if (weight > 0.0) sum.colour += weight * scene.of(behind, r, shadows);
  sum.alpha = 1.0 - passed;
  return sum;
}

picture blank(const frame::view& from) {
  picture p{from.width, from.height, {}, {}};
  const auto count = static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.height);
  for (auto& half : p.halves)
    half.resize(count);
  p.edge.assign(count, 0);
  return p;
}

}  // namespace

double encode(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

picture see(const lighting& scene, int samples, std::uint64_t seed) {
  const frame::stage& set = scene.set();
  picture p = blank(set.eye);
  for_each_pixel(set.eye, [&](int x, int y, std::size_t pixel) {
    static thread_local std::vector<fibre_hit> met;
    edge_finder edge(set);
    for (std::size_t half = 0; half < 2; ++half) {
      pixel_rays rays(set.eye, x, y, 2 * seed + half);
      colour_sum full;
      colour_sum lit;
      double alpha = 0;
      double entries = 0;
      for (int s = 0; s < samples; ++s) {
        ray r = rays.next();
        const opaque_hit behind = find_opaque(set.opaque, r);
        edge.see(behind);
        r.end = behind.distance;
        scene.fibres().find(r, met);
        const ray_sum seen = look_along(scene, r, behind, met, rays.random());
        full.see(seen.colour.full);
        lit.see(seen.colour.lit);
        alpha += seen.alpha;
        entries += static_cast<double>(met.size());
      }
      p.halves[half][pixel] = {glm::vec3(full.mean()), full.encoded(), lit.encoded(),
                               static_cast<float>(alpha / samples), static_cast<float>(entries / samples)};
    }
    p.edge[pixel] = edge.found() ? 1 : 0;
  });
  return p;
}

picture see_fibres(const frame::view& from, const fibre_rays& fibres, int samples, std::uint64_t seed) {
  picture p = blank(from);
  for_each_pixel(from, [&](int x, int y, std::size_t pixel) {
    static thread_local std::vector<fibre_hit> met;
    for (std::size_t half = 0; half < 2; ++half) {
      pixel_rays rays(from, x, y, 2 * seed + half);
      double alpha = 0;
      double entries = 0;
      for (int s = 0; s < samples; ++s) {
        fibres.find(rays.next(), met);
        double passed = 1;
        for (const fibre_hit& h : met)
          passed *= 1.0 - static_cast<double>(fibres.opacity(h));
        alpha += 1.0 - passed;
        entries += static_cast<double>(met.size());
      }
      p.halves[half][pixel].alpha = static_cast<float>(alpha / samples);
      p.halves[half][pixel].entries = static_cast<float>(entries / samples);
    }
  });
  return p;
}

frame::image mean_of(const picture& p) {
  frame::image mean(p.width, p.height);
  for (std::size_t i = 0; i < mean.pixels.size(); ++i)
    mean.pixels[i] = 0.5F * (p.halves[0][i].linear + p.halves[1][i].linear);
  return mean;
}

}  // namespace pelage::truth
