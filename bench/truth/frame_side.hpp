// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "frame/shading/scene.hpp"
#include "frame/stage.hpp"
#include "truth/fibre_rays.hpp"

namespace pelage::truth {

/// What the renderer's exact lists hold of each pixel, opaque objects left out.
struct drawn_coverage {
  std::vector<double> alpha;
  std::vector<double> entries;  ///< sum of coverages
};
[[nodiscard]] drawn_coverage draw_coverage(const frame::stage& set, const frame::view& seen);

/// The light of one source that the renderer lets through its map, found from what it shades with and without it.
class drawn_shadow {
 public:
  /// Casts the map of the light with this number. `set` must outlive it.
  drawn_shadow(const frame::stage& set, const frame::frame_settings& settings, std::size_t light);

  /// Transmittance to places on fibres; -1 where the light does not reach them at all.
  [[nodiscard]] std::vector<double> to_fibres(const std::vector<frame::lit_place>& places) const;
  /// The same to where a view's rays meet opaque objects.
  [[nodiscard]] std::vector<double> to_opaque(const std::vector<ray>& rays) const;

 private:
  [[nodiscard]] std::vector<double> divide(const std::vector<glm::vec3>& full, const std::vector<glm::vec3>& lit) const;

  frame::raster fragments_;
  frame::scene lit_;
  frame::scene full_;
};

}  // namespace pelage::truth
