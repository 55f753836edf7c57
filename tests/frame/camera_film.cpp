// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/camera_film.hpp"

#include "frame/fibres.hpp"

#include <pelage/composite/over.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelage::test {

using namespace frame;

constexpr int side = 24;

/// A ball before the sky or a wall, and one fibre that leaves fragments wherever a test says.
struct divided_scene {
  strands fibres = fibres_of({{{-1.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}}}, 0.01F, any_float(0.0F, 1.0F));
  view eye = perspective_view({0.0F, 0.0F, 5.0F}, glm::vec3(0.0F), 0.3F, side, side, 0.1F);
  raster from{fibres, eye, true};
  scene world{fibres, {}, {}, {glm::vec3(0.0F), 1.8F}, glm::vec3(0.5F, 0.6F, 0.7F), fibre_bsdf({}, glm::vec3(0.5F))};

  divided_scene() {
    world.opaque.parts.push_back({any_vec3(-0.5F, 0.5F) + glm::vec3(0.0F, 0.0F, 2.0F), glm::vec3(0.6F)});
    if (*rc::gen::arbitrary<bool>()) world.opaque.parts.push_back({{0.0F, 0.0F, -1000.0F}, glm::vec3(990.0F)});
  }
};

/// What a pixel's nine samples see on the average, each of the fragments before it, in order; in double.
glm::dvec3 mean_of_samples(const divided_scene& s, const shaded_fibres& shades, int x, int y,
                           const std::vector<pixel_fragment>& fragments) {
  glm::dvec3 mean(0.0);
  for (int i = 0; i < 9; ++i) {
    const auto offset = [](int k) { return (static_cast<float>(k) + 0.5F) / 3.0F; };
    const wide across(static_cast<float>(x) + offset(i % 3));
    const scene::backdrop_rays seen =
        s.world.seen_behind(s.eye.world_ray(across, wide(static_cast<float>(y) + offset(i / 3))));
    double passed = 1.0;
    for (const pixel_fragment& f : fragments) {
      if (f.depth >= seen.depth.lane[0]) break;
      const double alpha = static_cast<double>(s.fibres.mix(s.fibres.opacity, f.id, f.along) * f.coverage);
      mean += passed * alpha / 9.0 * glm::dvec3(shades.at(f.id, f.along));
      passed *= 1.0 - alpha;
    }
    mean += passed / 9.0 * glm::dvec3(lane_of(seen.radiance, 0));
  }
  return mean;
}

/// Fragments in order, at depths before the ball, behind it and behind the wall: those that the limit hides left out.
std::vector<pixel_fragment> draw_fragments(float limit) {
  std::vector<pixel_fragment> fragments;
  for (const float depth : {1.5F, 1.6F, 4.5F, 5.0F, 20.0F, 30.0F}) {
    const int count = *rc::gen::inRange(0, 12);
    for (int i = 0; i < count && depth < limit; ++i)
      fragments.push_back({0, depth, any_float(0.0F, 1.0F), any_float(0.0F, 1.0F)});
  }
  return fragments;
}

double distance(const glm::vec3& found, const glm::dvec3& expected) {
  return glm::length(glm::dvec3(found) - expected);
}

/// Calls `finish(film, x, y, fragments)` for all pixels and says how far the worst is from its samples' mean.
template <class Finish>
double worst_pixel(const Finish& finish) {
  const divided_scene s;
  const backdrop behind(s.eye, s.world, true);
  const shaded_fibres shades(s.world, s.from, {}, 0.0F);
  camera_film film(s.from, behind, shades, components::translucency);
  double worst = 0.0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y * side + x);
      std::vector<pixel_fragment> fragments = draw_fragments(behind.limit()[pixel]);
      finish(film, x, y, fragments);
      worst = std::max(worst, distance(film.picture().at(x, y), mean_of_samples(s, shades, x, y, fragments)));
    }
  }
  return worst;
}

TEST_CASE("at an object's edge each part of a pixel shows the fibres that lie before what is opaque in it") {
  holds("fragments in order", [] {
    RC_ASSERT(worst_pixel([](camera_film& film, int x, int y, const std::vector<pixel_fragment>& fragments) {
                film.finish(x, y, fragments, {});
              }) < 1e-5);
  });
  holds("by another blend", [] {
    const auto in_order = [](std::span<const layer> layers, const glm::vec3& background) {
      glm::vec4 sum(0.0F);
      for (const layer& l : layers)
        sum = over(sum, premultiply(l.radiance, l.alpha));
      return glm::vec3(over(sum, premultiply(background, 1.0F)));
    };
    RC_ASSERT(worst_pixel([&](camera_film& film, int x, int y, const std::vector<pixel_fragment>& fragments) {
                film.finish_by(in_order, x, y, fragments);
              }) < 1e-5);
  });
}

TEST_CASE("fragments that are lost behind an edge are not seen before it, in whatever number") {
  holds("equal fragments, all but the first lost", [] {
    const float coverage = any_float(0.1F, 1.0F);
    const auto lost_number = static_cast<std::size_t>(*rc::gen::inRange(1, 100));
    const float depth = *rc::gen::element(1.5F, 4.5F, 20.0F);
    RC_ASSERT(worst_pixel([&](camera_film& film, int x, int y, std::vector<pixel_fragment>& fragments) {
                if (film.limit()[static_cast<std::size_t>(y * side + x)] <= depth) {
                  fragments.clear();
                } else {
                  fragments.assign(lost_number + 1, {0, depth, coverage, 0.5F});
                }
                std::vector<tail> behind(film.tails(), empty_tail());
                const std::span<const pixel_fragment> all(fragments);
                if (!all.empty()) film.lose(x, y, all.subspan(1), behind);
                film.finish(x, y, all.first(std::min<std::size_t>(all.size(), 1)), behind);
              }) < 1e-4);
  });
}

}  // namespace pelage::test
