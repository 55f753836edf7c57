// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "frame/base/array_pool.hpp"
#include "frame/order/order_pass.hpp"
#include "frame/shadows/shadow_map.hpp"

namespace pelage::frame {

/// Per texel the fragments nearest to the light, each with the optical depth up to and including it, and the sum of
/// those behind them.
///
/// The tail's optical depth grows linearly with depth over the widest range round the mean depth of the fragments that
/// were not kept which neither reaches the last kept fragment nor the farthest one: with one fragment in the tail it is
/// this. With all fragments kept there is no tail and the answer is exact.
class k_buffer_shadow final : public shadow_map, public pixel_visitor {
 public:
  k_buffer_shadow(const raster& from, const solids& opaque, bool translucent = true);

  void expect(std::span<const std::uint32_t>) override {}
  void lose(int x, int y, std::span<const pixel_fragment> lost, std::span<tail> behind) override;
  void lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                  std::span<tail> behind) override;
  void finish(int x, int y, std::span<const pixel_fragment> nearest, std::span<const tail> behind) override;

 private:
  struct entry {
    float depth;
    std::uint32_t optical;  ///< of this fragment and all before it
  };
  struct texel {
    const entry* nearest;  ///< in order
    std::uint32_t count;   ///< of those
    std::uint32_t behind;  ///< optical depth of the fragments that are not kept
    float farthest;        ///< depth of the last of those
    float mean;            ///< their mean depth, weighted by optical depth

    [[nodiscard]] float share_before(float depth) const;
  };

  [[nodiscard]] float optical_before(std::size_t texel, float depth) const override;
  [[nodiscard]] std::uint64_t texel_bytes() const override;
  void prefetch_texels(std::size_t texel, int step) const override;

  /// Optical depth times depth, in units that end at the view's far depth.
  using pack = fragment_lanes::pack;
  [[nodiscard]] natural_of<pack> moment(natural_of<pack> optical, pack depth) const;

  float per_far_;  ///< 1 / the view's far depth
  std::vector<texel> texel_;
  array_pool<entry> entries_;
};

}  // namespace pelage::frame
