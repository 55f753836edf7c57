// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "frame/base/wide.hpp"
#include "frame/raster/fragment_lanes.hpp"
#include "frame/raster/raster.hpp"
#include "frame/scene/opaque_depth.hpp"

namespace pelage::frame {

/// What light has met on its way; to as many places as Real has lanes.
template <class Real>
struct passage_of {
  Real transmittance;  ///< the share that arrives, [0, open]
  Real fibres;         ///< fibres passed, each counted by the share of the texel that it covers, [0, 4096)
  Real open;           ///< the share that no opaque object stops, [0, 1]
};
using passage = passage_of<float>;

/// How a place on a fibre reads a map.
enum class map_lookup {
  filtered,  ///< the mean of the four nearest texels, weighted bilinearly
  jittered   ///< one texel, of the place moved by up to half a texel [Sintorn & Assarsson 2009, §3.3]
};

/// What passes from a light to any point. What a texel keeps of its fibres is up to the method, shadows/; all share
/// where a point is looked up, the depth of the nearest opaque object, and how many fibres an optical depth stands for.
class shadow_map {
 public:
  /// `from` must exist until the map is filled. `translucent` off: fibres are opaque.
  shadow_map(const raster& from, const solids& opaque, bool translucent);
  virtual ~shadow_map() = default;

  /// The share of the light that reaches a world position, [0, 1]: the mean of the four nearest texels, weighted
  /// bilinearly. What lies less than `bias` before the position does not count; nor does anything outside the map.
  [[nodiscard]] float transmittance_to(const glm::vec3& world, float bias) const;

  /// The same with the number of fibres in the way and what opaque objects leave. The number is the texel's sum of
  /// coverages in proportion to the optical depth: exact behind the last fibre, and wherever all are alike; 0 where
  /// none stops light. Behind an opaque object it is that of all fibres before the object.
  [[nodiscard]] passage passed_to(const glm::vec3& world, float bias) const;

  /// Where positions are looked up, as many as there are lanes.
  struct spots {
    std::array<std::uint32_t, wide_width> first;  ///< the upper left of four texels
    std::uint32_t inside;                         ///< the bits of the positions that lie in the map
    wide across, down;                            ///< where between the texels' centres, [0, 1]
    wide depth;                                   ///< of the receiver in the upper left texel,
    wide growth_across, growth_down;              ///< and how much deeper it lies in the next ones
    bool among_fibres;                            ///< objects stop no light there: their own surfaces
    bool is_one_texel;                            ///< the upper left alone, and `depth` is there
  };

  /// Of the positions whose bits are set, filtered. They lie on fibres along `tangent`: in each texel only what lies
  /// `bias` before the fibre's own depth there counts, so that it does not shadow itself.
  [[nodiscard]] spots find_on_fibres(const wide3& world, const wide3& tangent, wide bias, std::uint32_t set) const;

  /// The same in one texel: that of the position moved by lookup_jitter() of its lane's seed. A seed that is the
  /// place's own makes noise that is the same in every frame, by any number of threads.
  [[nodiscard]] spots find_jittered_on_fibres(const wide3& world, const wide3& tangent, wide bias,
                                              const std::array<std::uint32_t, wide_width>& seed,
                                              std::uint32_t set) const;

  /// The same on opaque objects' surfaces with a unit normal, without what the objects themselves hide: the four texels
  /// know of it too little to tell a surface from the one beside it.
  [[nodiscard]] spots find_on_surfaces(const wide3& world, const wide3& normal, std::uint32_t set) const;

  /// Asks the processor to load what passed_to() will read. What lies behind a pointer needs two steps: call it for
  /// many positions with step 0, then for all of them with step 1.
  void prefetch(const spots& at, int step) const;

  /// Each lane has the bits that its position has alone; as outside the map where it was not set.
  [[nodiscard]] passage_of<wide> passed_to(const spots& at) const;

  /// View depth of the nearest opaque object in each texel, +inf where there is none.
  [[nodiscard]] std::span<const float> limit() const { return limit_; }

  /// Memory of the whole map.
  [[nodiscard]] std::uint64_t bytes() const;

 protected:
  /// Optical depth of the fibres before a view depth, units of 2⁻²⁰ octaves, [0, 2³²]. Never falls as depth grows.
  [[nodiscard]] virtual float optical_before(std::size_t texel, float depth) const = 0;
  [[nodiscard]] virtual std::uint64_t texel_bytes() const = 0;

  /// The part of prefetch() for a texel and the next.
  virtual void prefetch_texels(std::size_t texel, int step) const {
    (void)texel;
    (void)step;
  }

  /// A fragment's opacity times coverage.
  [[nodiscard]] float alpha(const pixel_fragment& f) const;
  [[nodiscard]] fragment_lanes::pack alpha(const fragment_lanes& all) const;

  /// Says once what all fragments of a texel sum up to. `coverage`: in units of 2⁻²⁰.
  void set_sums(std::size_t texel, std::uint32_t coverage, std::uint32_t optical);

  [[nodiscard]] std::size_t texels() const { return limit_.size(); }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(light_.width) + static_cast<std::size_t>(x);
  }

 private:
  /// Positions in the light's view, each with the slope of what it lies on.
  [[nodiscard]] spots find(const wide3& seen, const wide2& slope, wide bias, std::uint32_t set,
                           bool among_fibres) const;

  /// What light passes to each spot in one of its four texels: transmittance, fibres, open.
  [[nodiscard]] wide3 passed_in(const spots& at, std::size_t offset, wide depth) const;

  /// The lanes whose pixel coordinates and depth lie in the map; the borders belong to it. A NaN is nowhere.
  [[nodiscard]] std::uint32_t inside(const wide2& pixel, wide depth) const;

  [[nodiscard]] wide2 slope_on_fibre(const wide3& seen, const wide3& tangent) const;

  [[nodiscard]] wide3 ray_to(const wide3& seen) const;

  const view_opacity& opacity_;  ///< while the map is filled
  view light_;
  bool translucent_;
  std::vector<float> limit_;
  std::vector<float> fibres_per_octave_;
};

}  // namespace pelage::frame
