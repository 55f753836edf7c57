// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "frame/base/random.hpp"
#include "frame/model/strands.hpp"

namespace pelage::truth {

/// Distances along it are in lengths of its direction.
struct ray {
  glm::dvec3 origin;
  glm::dvec3 direction;  ///< not zero
  double end = std::numeric_limits<double>::infinity();
};

/// Where a ray enters a fibre.
struct fibre_hit {
  double distance;
  std::uint32_t segment;
  float along;  ///< on the segment's axis, [0, 1]
};

/// Fibres as Embree's round linear curves: a ball of the fibre's radius drawn along each strand, its joints without
/// inner surfaces.
///
/// A fibre is met where a ray enters it. Entries into segments that share a joint, at most four radii apart along the
/// ray, are one; a strand that comes back later is met again.
class fibre_rays {
 public:
  static constexpr std::uint32_t nobody = 0xffffffffU;

  /// Builds Embree's hierarchy; `fibres` must outlive it. Throws std::runtime_error where Embree gives none.
  explicit fibre_rays(const frame::strands& fibres);
  ~fibre_rays();
  fibre_rays(const fibre_rays&) = delete;
  fibre_rays& operator=(const fibre_rays&) = delete;

  /// Replaces `met` by all entries, nearest first.
  void find(const ray& r, std::vector<fibre_hit>& met) const;

  /// What all fibres on the way let pass, the product of 1 - opacity; below 10⁻⁴ it is 0. The segment `own` and those
  /// that share a joint with it do not count: a fibre does not shadow the place where the ray leaves it.
  [[nodiscard]] double transmittance(const ray& r, std::uint32_t own) const;

  /// One draw: the nearest entry of those that each stop the ray with the probability of their opacity. An entry at a
  /// joint may be drawn twice.
  [[nodiscard]] std::optional<fibre_hit> draw_nearest(const ray& r, frame::random_stream& random) const;

  /// One draw: whether any entry stops the ray, `own` as above.
  [[nodiscard]] bool draw_blocked(const ray& r, std::uint32_t own, frame::random_stream& random) const;

  [[nodiscard]] const frame::strands& fibres() const { return fibres_; }
  [[nodiscard]] float opacity(const fibre_hit& h) const { return fibres_.mix(fibres_.opacity, h.segment, h.along); }
  [[nodiscard]] double build_seconds() const { return build_seconds_; }

 private:
  struct embree;
  const frame::strands& fibres_;
  std::unique_ptr<embree> embree_;
  double build_seconds_ = 0;
};

}  // namespace pelage::truth
