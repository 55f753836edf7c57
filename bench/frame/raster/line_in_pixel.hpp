// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/line_width.hpp>

#include <cstdint>

#include "frame/model/strands.hpp"
#include "frame/raster/outline.hpp"
#include "frame/raster/segment_in_pixel.hpp"
#include "frame/scene/view.hpp"

namespace pelage::frame {

/// How segments become fragments.
enum class primitive {
  segment,  ///< by the share of each pixel's disc that they cover
  line      ///< as lines without a position inside the pixel [Svoboda §1.2.3]
};

/// At which depths a view takes the widths of lines. [Svoboda §1.2.3]
struct line_depths {
  float nearest = 0.0F;   ///< view depth of the first bin, or of all
  float bin = 0.0F;       ///< depth of a bin; 0: all lines have their width at `nearest`
  float last = 0.0F;      ///< number of the last bin
  float widening = 1.0F;  ///< how much wider than its fibre where it lies a line may be, [1, inf]

  /// The depth at which a line is as wide as its fibre: where the bin of its farther end begins.
  template <class Real>
  [[nodiscard]] Real depth_of_bin(Real farther) const;
};

/// Those of a view. `bins`: into which the depths of all points are divided; 0: all lines have their width at the depth
/// `at`, as in a light's map. O(points).
[[nodiscard]] line_depths line_depths_of(const strands& fibres, const view& from, std::uint32_t bins, float at);

/// What a segment leaves as a line where the pixel's centre is (x, y): along its longer side on the screen it draws the
/// pixels of each column (or row) whose centres lie within half its width of it, one where the fibre is thinner than a
/// pixel; the nearer side's pixel where the line runs between two. A column through the point where two segments meet
/// belongs to the one that begins there.
///
/// Coverage is mean_line_width_share() at either end, linear between. A segment that is a point on the screen, or whose
/// end is nearer than the near plane, leaves nothing. Without `antialias` coverage is 1.
template <class Real>
[[nodiscard, gnu::always_inline]] inline segment_in_pixel<Real> line_in_pixel(const projected_point<Real>& start,
                                                                              const projected_point<Real>& end, Real x,
                                                                              Real y, const view& from,
                                                                              const line_depths& depths,
                                                                              bool antialias) {
  const Real zero(0.0F);
  const Real one(1.0F);
  const Real start_depth = zero - start.z;
  const Real end_depth = zero - end.z;
  const auto pixel_at = [&](Real depth) { return from.pixel_at(glm::vec<3, Real>(zero, zero, zero - depth)); };

  const auto steep = absolute(end.pixel_y - start.pixel_y) > absolute(end.pixel_x - start.pixel_x);
  const Real first = select(steep, start.pixel_y, start.pixel_x);
  const Real last = select(steep, end.pixel_y, end.pixel_x);
  const Real column = select(steep, y, x);
  const Real beside = select(steep, start.pixel_x, start.pixel_y);
  const Real beside_end = select(steep, end.pixel_x, end.pixel_y);
  const Real place = (column - first) / (last - first);
  const Real offset = select(steep, x, y) - (beside + place * (beside_end - beside));

  const Real at = depths.depth_of_bin(greatest(start_depth, end_depth));
  const Real half_width = greatest(greatest(start.radius, end.radius) / pixel_at(at), Real(0.5F));

  const Real along = from.perspective ? place * start_depth / (end_depth + place * (start_depth - end_depth)) : place;
  const Real inside = saturate(along);
  const auto share_at = [&](Real radius, Real depth) {
    return mean_line_width_share(radius, Real(0.5F) * pixel_at(depths.bin > 0.0F ? depth : Real(depths.nearest)));
  };
  const Real near_share = share_at(start.radius, start_depth);
  const Real far_share = share_at(end.radius, end_depth);
  Real share = antialias ? near_share + inside * (far_share - near_share) : one;

  share = select(offset < half_width, share, zero);
  share = select(offset < zero - half_width, zero, share);
  const Real forwards = select(column < first, zero, select(column < last, share, zero));
  const Real backwards = select(column > first, zero, select(column > last, share, zero));
  share = select(first < last, forwards, select(first > last, backwards, zero));
  const Real near_plane(from.near_plane);
  share = select(start_depth < near_plane, zero, select(end_depth < near_plane, zero, share));
  return {start_depth + inside * (end_depth - start_depth), share, inside};
}

template <class Real>
Real line_depths::depth_of_bin(Real farther) const {
  if (!(bin > 0.0F)) return Real(nearest);
  const Real position = greatest((farther - Real(nearest)) / Real(bin), Real(0.0F));
  return Real(nearest) + Real(bin) * whole_part(least(position, Real(last)));
}

}  // namespace pelage::frame
