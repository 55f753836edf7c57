// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// Puts n follow strands round each strand of a model, each guide first and then its own n, so that the
/// result has (n + 1) times the strands.
///
/// A follow strand has its guide's number of points, thickness, colour and transparency. Its root lies in the
/// disc of `radius` (model units, [0, +inf)) across the guide's root; toward the tip it draws in on the
/// guide, so that the bundle tapers to a lock, it wavers by a fraction of the radius, and it ends at 85 % to
/// 100 % of the guide's length. No point is farther than `radius` from the guide's polyline. Strands of 0 or
/// 1 points are copied as they are.
///
/// The result depends on the arguments alone. n = 0 gives the model back. Throws std::invalid_argument for a
/// radius out of range and std::length_error where the points would not fit 32-bit indices. O(points * n),
/// parallel over guides.
[[nodiscard]] hair_model add_follow_strands(const hair_model& guides, std::uint32_t n, float radius,
                                            std::uint64_t seed);

}  // namespace pelage::frame
