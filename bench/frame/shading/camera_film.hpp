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
/// A fibre counts with the share of the backdrop's samples that it lies in front of: at an object's edge neither hair
/// nor background shines through the object.
class camera_film final : public pixel_visitor {
 public:
  /// `behind`, `shades`: of the raster's eye. All references must outlive the film.
  camera_film(const raster& from, const backdrop& behind, const shaded_fibres& shades, components shown);

  /// See backdrop::limit().
  [[nodiscard]] std::span<const float> limit() const { return behind_.limit(); }

  void expect(std::span<const std::uint32_t> fragments_per_pixel) override { (void)fragments_per_pixel; }
  void lose(int x, int y, std::span<const pixel_fragment> lost, tail& behind) override;
  void lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                  std::span<tail> behind) override;
  void finish(int x, int y, std::span<const pixel_fragment> nearest, const tail& behind) override;

  /// For methods that blend in another way than finish(): a pixel's fragments as layers, what is seen behind them, and
  /// what both come to. May be called for different pixels at once.
  void look_at(int x, int y, std::span<const pixel_fragment> all, std::vector<layer>& layers) const;
  [[nodiscard]] const glm::vec3& behind_fibres(int x, int y) const { return picture_.at(x, y); }  ///< before set()
  void set(int x, int y, const glm::vec3& colour) { picture_.at(x, y) = colour; }

  [[nodiscard]] const image& picture() const { return picture_; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const;
  [[nodiscard]] float visible_coverage(std::size_t pixel, const pixel_fragment& f) const;
  [[nodiscard]] float opacity(const pixel_fragment& f) const;

  const raster& from_;
  const backdrop& behind_;
  const shaded_fibres& shades_;
  components shown_;
  image picture_;  ///< what is behind the fibres, until a pixel is finished
};

}  // namespace pelage::frame
