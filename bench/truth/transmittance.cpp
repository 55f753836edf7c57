// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/transmittance.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

#include "truth/camera.hpp"

namespace pelage::truth {

seen_places places_seen(const lighting& scene, int samples, std::uint64_t seed) {
  const frame::stage& set = scene.set();
  seen_places all;
  std::vector<fibre_hit> met;
  for (int y = 0; y < set.eye.height; ++y) {
    for (int x = 0; x < set.eye.width; ++x) {
      pixel_rays rays(set.eye, x, y, seed);
      for (int s = 0; s < samples; ++s) {
        ray r = rays.next();
        const opaque_hit behind = find_opaque(set.opaque, r);
        r.end = behind.distance;
        scene.fibres().find(r, met);
        double share = 1;
        for (const fibre_hit& h : met) {
          const auto alpha = static_cast<double>(scene.fibres().opacity(h));
          all.fibre.push_back({h.segment, h.along, glm::vec3(-glm::normalize(r.direction))});
          all.fibre_share.push_back(share * alpha);
          share *= 1.0 - alpha;
          if (share < 1e-3) break;
        }
        if (share < 1e-3 || !behind.exists()) continue;
        all.opaque.push_back(r);
        all.opaque_share.push_back(share * (1.0 - behind.haze));
      }
    }
  }
  return all;
}

true_shadows shadows_at(const lighting& scene, const seen_places& places) {
  const frame::stage& set = scene.set();
  const std::size_t lights = set.lights.size();
  true_shadows found{std::vector<std::vector<double>>(lights, std::vector<double>(places.fibre.size())),
                     std::vector<std::vector<double>>(lights, std::vector<double>(places.opaque.size()))};
  for (std::size_t i = 0; i < lights; ++i) {
    tbb::parallel_for(std::size_t{0}, places.fibre.size(), [&](std::size_t p) {
      const frame::lit_place& at = places.fibre[p];
      const glm::dvec3 place = scene.place_of(fibre_hit{0.0, at.segment, at.along});
      found.to_fibres[i][p] = scene.passing(scene.arriving(set.lights[i], place).way, at.segment);
    });
    tbb::parallel_for(std::size_t{0}, places.opaque.size(), [&](std::size_t p) {
      ray seen = places.opaque[p];
      seen.end = std::numeric_limits<double>::infinity();
      const glm::dvec3 place = scene.place_of(find_opaque(set.opaque, seen), seen);
      found.to_opaque[i][p] = scene.passing(scene.arriving(set.lights[i], place).way, fibre_rays::nobody);
    });
  }
  return found;
}

shadow_error compare(const std::vector<double>& drawn, const std::vector<double>& truth,
                     const std::vector<double>& share) {
  double weight = 0;
  double map = 0;
  double rays = 0;
  double squares = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i] < 0.0) continue;
    weight += share[i];
    map += share[i] * drawn[i];
    rays += share[i] * truth[i];
    squares += share[i] * (drawn[i] - truth[i]) * (drawn[i] - truth[i]);
  }
  if (!(rays > 0.0)) return {};
  return {rays / weight, map / rays - 1.0, std::sqrt(squares / weight)};
}

}  // namespace pelage::truth
