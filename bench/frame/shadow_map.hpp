// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "frame/order_pass.hpp"
#include "frame/solids.hpp"

namespace pelage::frame {

/// What passes from a light to any point: per texel the fragments nearest to the light, each with the optical depth
/// up to and including it, the sum of those behind them, and the depth of the nearest opaque object.
///
/// Between the last kept fragment and the farthest one the tail's optical depth grows linearly with depth: what a
/// texel knows of fragments that it did not keep. With all fragments kept there is no tail and the answer is exact.
class shadow_map final : public pixel_visitor {
 public:
  /// `k`: fragments kept a texel unless expect() announces all of them. `translucent` off: fibres are opaque.
  shadow_map(const raster& from, const solids& opaque, std::uint32_t k, bool translucent = true);

  void expect(std::span<const std::uint32_t> fragments_per_pixel) override;
  void lose(int x, int y, fragment lost, const touch& where, tail& behind) override;
  void finish(int x, int y, std::span<const fragment> nearest, const tail& behind) override;

  /// The share of the light that reaches a world position, [0, 1]: the mean of the four nearest texels, weighted
  /// bilinearly. What lies less than `bias` before the position does not count; nor does anything outside the map.
  [[nodiscard]] float transmittance_to(const glm::vec3& world, float bias) const;

  /// View depth of the nearest opaque object in each texel, +inf where there is none.
  [[nodiscard]] std::span<const float> limit() const { return limit_; }
  [[nodiscard]] std::uint64_t bytes() const;

  /// A texel's width at a world position, length units.
  [[nodiscard]] float texel_at(const glm::vec3& world) const;

 private:
  struct entry {
    float depth;
    std::uint32_t optical;  ///< of this fragment and all before it
  };
  struct texel {
    std::uint32_t count;   ///< entries in use
    std::uint32_t behind;  ///< optical depth of the fragments that are not kept
    float farthest;        ///< depth of the last of those
  };

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(from_.from().width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] float transmittance_in(std::size_t t, float depth) const;
  [[nodiscard]] float alpha(fragment f, const touch& where) const;

  const raster& from_;
  bool translucent_;
  std::vector<std::size_t> first_;  ///< where each texel's entries begin
  std::vector<texel> texel_;
  std::vector<entry> entry_;
  std::vector<float> limit_;
};

/// View depth of the nearest opaque object along the ray through pixel coordinates, +inf where there is none.
[[nodiscard]] float opaque_depth(const view& from, const solids& opaque, const glm::vec2& pixel);

/// The same for all pixels' centres. Parallel.
[[nodiscard]] std::vector<float> opaque_depths(const view& from, const solids& opaque);

}  // namespace pelage::frame
