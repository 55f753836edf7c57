// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "frame/fibre_bsdf.hpp"
#include "frame/image.hpp"
#include "frame/layer.hpp"
#include "frame/lights.hpp"
#include "frame/opaque_depth.hpp"
#include "frame/order_pass.hpp"
#include "frame/shadow_map.hpp"
#include "frame/solids.hpp"

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

/// A placed light and, where shadows are drawn, its map.
struct lit {
  light source;
  std::unique_ptr<shadow_map> shadow;
};

/// Everything that light meets, and what comes back to an eye.
struct scene {
  const strands& fibres;
  solids opaque;
  std::vector<lit> lights;
  sphere bounds;  ///< of the fibres
  glm::vec3 sky;  ///< radiance from all sides, linear RGB
  fibre_bsdf bsdf;

  /// Radiance of a fibre toward `to_eye` (unit) at a place on a segment, linear RGB.
  [[nodiscard]] glm::vec3 fibre_radiance(std::uint32_t segment, float along, const glm::vec3& to_eye) const;

  /// Radiance of an opaque object where a ray hits it.
  [[nodiscard]] glm::vec3 solid_radiance(const glm::vec3& position, const solid_hit& hit) const;

  /// What a ray that misses everything sees.
  [[nodiscard]] glm::vec3 background(const glm::vec3& direction) const;
};

/// The camera's end of the path: gathers a pixel's fibres over the opaque objects and the background.
///
/// With anti-aliasing a pixel sees the opaque objects by 3 × 3 samples, and a fibre counts with the share of samples
/// that it lies in front of: at an object's edge neither hair nor background shines through the object.
class camera_film final : public pixel_visitor {
 public:
  camera_film(const raster& from, const scene& world, components shown, bool antialias);

  /// View depth of the farthest opaque sample in each pixel, +inf where one sees none: what is behind is hidden.
  [[nodiscard]] std::span<const float> limit() const { return limit_; }

  void expect(std::span<const std::uint32_t> fragments_per_pixel) override { (void)fragments_per_pixel; }
  void lose(int x, int y, std::span<const seen_fragment> lost, tail& behind) override;
  void finish(int x, int y, std::span<const seen_fragment> nearest, const tail& behind) override;

  /// For methods that blend in another way than finish(): a pixel's fragments as layers, what is seen behind them, and
  /// what both come to. May be called for different pixels at once.
  void look_at(int x, int y, std::span<const seen_fragment> all, std::vector<layer>& layers) const;
  [[nodiscard]] glm::vec3 behind_fibres(int x, int y) const;
  void set(int x, int y, const glm::vec3& colour) { picture_.at(x, y) = colour; }

  [[nodiscard]] const image& picture() const { return picture_; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const;
  [[nodiscard]] glm::vec2 sample_position(int x, int y, int sample) const;
  [[nodiscard]] float visible_coverage(int x, int y, const touch& where) const;
  [[nodiscard]] float opacity(const seen_fragment& f) const;
  [[nodiscard]] glm::vec3 radiance(const seen_fragment& f, const view_ray& ray) const;

  const raster& from_;
  const scene& world_;
  components shown_;
  int side_;                         ///< samples of opaque objects along a pixel's side
  std::vector<float> sample_depth_;  ///< side² a pixel
  std::vector<float> limit_;
  image picture_;
};

}  // namespace pelage::frame
