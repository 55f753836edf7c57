// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "frame/image/image.hpp"
#include "frame/order/layer.hpp"
#include "frame/order/order_pass.hpp"
#include "frame/shading/backdrop.hpp"
#include "frame/shading/shaded_fibres.hpp"

namespace pelage::frame {

/// Which of the framework's parts are drawn: the columns of Yu12 Fig. 10.
enum class components {
  single,        ///< opaque fibres, no shadows
  shadows,       ///< opaque fibres that shadow each other
  translucency,  ///< half-transparent fibres, no shadows
  full           ///< both
};

[[nodiscard]] constexpr bool has_shadows(components c) {
  return c == components::shadows || c == components::full;
}
[[nodiscard]] constexpr bool has_translucency(components c) {
  return c == components::translucency || c == components::full;
}

/// The camera's end of the path: gathers a pixel's fibres over the opaque objects and the background.
///
/// At an object's edge neither hair nor background shines through the object: what a pixel sees beside the edge is
/// composited apart from what it sees before it.
class camera_film final : public pixel_visitor {
 public:
  /// `behind`, `shades`: of the raster's eye. `slices`: of the depths that are seen, each with tails of its own for
  /// what is not among a pixel's K nearest; 0: that is lost. All references must outlive the film.
  camera_film(const raster& from, const backdrop& behind, const shaded_fibres& shades, components shown,
              std::uint32_t slices = 1);

  /// See backdrop::limit().
  [[nodiscard]] std::span<const float> limit() const { return behind_.limit(); }

  void expect(std::span<const std::uint32_t> fragments_per_pixel) override { (void)fragments_per_pixel; }
  /// For each slice one for what lies before an object's edge, then as many for what lies behind it.
  [[nodiscard]] std::size_t tails() const override { return 2 * std::size_t{slices_}; }
  void lose(int x, int y, std::span<const pixel_fragment> lost, std::span<tail> behind) override;
  void lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                  std::span<tail> behind) override;
  void finish(int x, int y, std::span<const pixel_fragment> nearest, std::span<const tail> behind) override;

  /// For methods that blend in another way than finish(): `blend(std::span<const layer>, background)` gives what is
  /// seen of a pixel's fragments as layers, in the order in which they come, before a background. Where an edge divides
  /// the pixel, it is asked for either part. May be called for different pixels at once.
  template <class Blend>
  void finish_by(const Blend& blend, int x, int y, std::span<const pixel_fragment> all);

  [[nodiscard]] const image& picture() const { return picture_; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const;
  [[nodiscard]] float opacity(const pixel_fragment& f) const;
  [[nodiscard]] std::uint32_t slice_of(float depth) const;

  const raster& from_;
  const backdrop& behind_;
  const shaded_fibres& shades_;
  components shown_;
  std::uint32_t slices_;
  depth_range depths_;  ///< that the slices divide
  image picture_;       ///< what is behind the fibres, until a pixel is finished
};

// ---------------------------------------------------------------------------------------------------------

template <class Blend>
void camera_film::finish_by(const Blend& blend, int x, int y, std::span<const pixel_fragment> all) {
  static thread_local std::vector<layer> layers;
  static thread_local std::vector<layer> before;
  layers.clear();
  before.clear();
  const divided_backdrop<float> behind = behind_.at(index(x, y));
  for (const pixel_fragment& f : all) {
    layers.push_back({fragment_of(f), opacity(f) * f.coverage, shades_.at(f.id, f.along)});
    if (f.depth < behind.edge) before.push_back(layers.back());
  }
  glm::vec3& colour = picture_.at(x, y);
  if (before.size() == layers.size()) {
    colour = blend(std::span<const layer>(layers), behind.all_light);
    return;
  }
  const float near_share = 1.0F - behind.far_share;
  colour = near_share * blend(std::span<const layer>(before), (behind.all_light - behind.far_light) / near_share) +
           behind.far_share * blend(std::span<const layer>(layers), behind.far_light / behind.far_share);
}

}  // namespace pelage::frame
