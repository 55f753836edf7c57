// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// Between which guides a strand lies: barycentric coordinates in the triangle of three.
struct guide_mix {
  std::array<std::uint32_t, 3> guide;  ///< strands' numbers; the first is its own, to which it clumps
  std::array<float, 3> weight;         ///< [0, 1] each, their sum 1 within 2^-22; a guide of weight 0 is not read
};

/// Guides are neighbours where their roots are at most so many mean spacings apart, the mean distance from a guide's
/// root to the nearest other place where one is.
inline constexpr double greatest_spacing = 4.0;

/// n mixes for each guide, one guide's after another's. The other two guides are drawn by the seed: one of the eight
/// nearest neighbours at the root, and one of those two that are nearest to both. The guide's own weight is the
/// greatest, else all places in the triangle are as likely. A guide with one neighbour is mixed with that alone; one
/// with none, or with fewer than two points, stands alone, and is no one's neighbour where it has fewer than two.
///
/// Depends on the arguments alone. O(strands · (n + log strands)), parallel over guides.
[[nodiscard]] std::vector<guide_mix> mix_guides(const hair_model& guides, std::uint32_t n, std::uint64_t seed);

/// The strand of each mix, at every parameter t, [0, 1] from root to tip, the weighted mean of its guides there, in all
/// that a point has: a strand of one weight is that guide, bit for bit. It has as many points as the guide of weight
/// that has most; the others are resampled between their points. `clump`, [0, 1]: the strand is drawn to its own guide
/// by the share clump · t of the way, so that at 1 all end at the guide's tip, and roots stay. A mix of more than one
/// guide is of guides that have points.
///
/// Throws std::invalid_argument for a clump out of range and std::length_error where points would not fit 32-bit
/// indices. O(points), parallel over strands.
[[nodiscard]] hair_model interpolate_strands(const hair_model& guides, std::span<const guide_mix> mixes, float clump);

/// Each guide followed by its n strands of mix_guides(); n = 0 gives the model back. Throws as interpolate_strands().
[[nodiscard]] hair_model add_interpolated_strands(const hair_model& guides, std::uint32_t n, float clump,
                                                  std::uint64_t seed);

}  // namespace pelage::frame
