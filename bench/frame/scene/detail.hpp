// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "frame/model/placement.hpp"
#include "frame/model/strands.hpp"
#include "frame/scene/view.hpp"

namespace pelage::frame {

/// How far strands may be from what they are, as seen; 0: not at all.
struct detail_errors {
  float segment = 0.0F;  ///< neighbouring segments that stay within so many pixels are drawn as one, [0, 64]
  float strand = 0.0F;   ///< strands thinner than so many pixels are drawn for their neighbours, too, [0, 64]

  [[nodiscard]] bool any() const { return segment > 0.0F || strand > 0.0F; }
};

/// Strands to draw, and how many there are of them.
struct detailed_strands {
  strands fibres;
  std::uint32_t count = 0;
};

/// Copies of a model's strands, as coarse as all views let them be, in the order of the copies and of the strands in
/// each. `first_point`: as in hair_model. A copy's strand is one of rank strand_rank(), by its number among those of
/// all copies; its share is that of the widest that any view sees of it. A strand's points follow chord_run, with the
/// least tolerance among the views; the radius may be off by the share `segment` of itself, or by as many pixels where
/// it is wider than one, before a strand is widened for others. Points that stay have their own tangents and colours;
/// what a point in between had is lost.
///
/// Same bits for any number of threads. O(copies · points · views), parallel over strands; a byte a point of the model
/// beside the result. Throws std::length_error for more than 2³² - 1 points, std::runtime_error where several
/// copies and what a frame needs for them do not fit into the machine's memory.
[[nodiscard]] detailed_strands strands_in_detail(const strands& whole, std::span<const std::uint32_t> first_point,
                                                 std::span<const placement> copies, std::span<const view> views,
                                                 const detail_errors& errors);

}  // namespace pelage::frame
