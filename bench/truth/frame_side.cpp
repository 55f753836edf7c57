// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/frame_side.hpp"

#include <algorithm>
#include <utility>

namespace pelage::truth {
namespace {

/// Sums up each pixel's list.
class coverage_sum final : public frame::pixel_visitor {
 public:
  coverage_sum(const frame::raster& from, drawn_coverage& sum) : from_(from), sum_(sum) {}

  void expect(std::span<const std::uint32_t>) override {}
  void lose(int, int, std::span<const frame::pixel_fragment>, std::span<tail>) override {}
  void finish(int x, int y, std::span<const frame::pixel_fragment> nearest, std::span<const tail>) override {
    double passed = 1;
    double entries = 0;
    for (const frame::pixel_fragment& f : nearest) {
      const auto coverage = static_cast<double>(f.coverage);
      passed *= 1.0 - coverage * static_cast<double>(from_.mix(from_.fibres().opacity, f.id, f.along));
      entries += coverage;
    }
    const auto at = static_cast<std::size_t>(y * from_.from().width + x);
    sum_.alpha[at] = 1.0 - passed;
    sum_.entries[at] = entries;
  }

 private:
  const frame::raster& from_;
  drawn_coverage& sum_;
};

}  // namespace

drawn_coverage draw_coverage(const frame::stage& set, const frame::view& seen) {
  const auto count = static_cast<std::size_t>(seen.width) * static_cast<std::size_t>(seen.height);
  drawn_coverage sum{std::vector<double>(count), std::vector<double>(count)};
  const frame::raster fragments(set.fibres, seen, true);
  coverage_sum visitor(fragments, sum);
  frame::run_order_pass(fragments, {}, {frame::order_method::full_sort, 16, {}}, visitor);
  return sum;
}

namespace {

/// The scene with one light and without the sky.
frame::scene dark_scene(const frame::stage& set, const frame::frame_settings& settings, std::size_t light) {
  frame::scene s{set.fibres, set.opaque,      {},
                 set.round,  glm::vec3(0.0F), frame::fibre_bsdf(settings.look, glm::vec3(0.3F))};
  s.lights.push_back({set.lights[light], nullptr});
  s.lights.front().source.colour = glm::vec3(1.0F);
  return s;
}

}  // namespace

drawn_shadow::drawn_shadow(const frame::stage& set, const frame::frame_settings& settings, std::size_t light)
    : fragments_(set.fibres, set.light_views[light], true),
      lit_(dark_scene(set, settings, light)),
      full_(dark_scene(set, settings, light)) {
  const frame::order_options options{settings.order, settings.k, set.drawing_order};
  full_.lights.front().shadow = frame::cast(settings.shadow, fragments_, set.opaque, options, true).map;
}

std::vector<double> drawn_shadow::to_fibres(const std::vector<frame::lit_place>& places) const {
  std::vector<glm::vec3> lit(places.size());
  std::vector<glm::vec3> full(places.size());
  lit_.fibre_radiance(places, lit);
  full_.fibre_radiance(places, full);
  return divide(full, lit);
}

std::vector<double> drawn_shadow::to_opaque(const std::vector<ray>& rays) const {
  std::vector<glm::vec3> lit(rays.size());
  std::vector<glm::vec3> full(rays.size());
  constexpr auto width = static_cast<std::size_t>(frame::wide_width);
  for (std::size_t first = 0; first < rays.size(); first += width) {
    const std::size_t count = std::min(width, rays.size() - first);
    frame::wide3_builder origin;
    frame::wide3_builder direction;
    for (std::size_t k = 0; k < width; ++k) {
      const ray& r = rays[first + std::min(k, count - 1)];
      origin.set(static_cast<int>(k), glm::vec3(r.origin));
      direction.set(static_cast<int>(k), glm::vec3(r.direction));
    }
    const frame::wide_rays together{origin.done(), direction.done()};
    const auto seen_lit = lit_.seen_behind(together);
    const auto seen_full = full_.seen_behind(together);
    for (std::size_t k = 0; k < count; ++k) {
      lit[first + k] = frame::lane_of(seen_lit.radiance, static_cast<int>(k));
      full[first + k] = frame::lane_of(seen_full.radiance, static_cast<int>(k));
    }
  }
  return divide(full, lit);
}

std::vector<double> drawn_shadow::divide(const std::vector<glm::vec3>& full, const std::vector<glm::vec3>& lit) const {
  std::vector<double> share(lit.size(), -1.0);
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (lit[i].x > 1e-9F) share[i] = static_cast<double>(full[i].x) / static_cast<double>(lit[i].x);
  }
  return share;
}

}  // namespace pelage::truth
