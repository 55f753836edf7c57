// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "frame/model/bust.hpp"
#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// Makes the built-in hairstyle on the bust of bust.hpp: parted at one side, wavy, shoulder-length.
///
/// Every strand has segments_per_strand segments. All points are finite and outside the bust. Strands come in
/// an order without spatial meaning, so the first n are a thinner version of the same hair. Thickness (root
/// to tip) and colour (per lock and strand) are given per point.
///
/// The model depends on the three arguments alone: the same bits on any number of threads. strands = 0 gives
/// an empty model. Throws std::invalid_argument for segments_per_strand = 0, and std::length_error where the
/// points would not fit 32-bit indices. O(strands * segments), parallel over strands.
[[nodiscard]] hair_model make_built_in(std::uint32_t strands, std::uint32_t segments_per_strand, std::uint64_t seed);

}  // namespace pelage::frame
