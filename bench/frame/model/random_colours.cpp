// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/random_colours.hpp"

#include <pelage/core/mixed_bits.hpp>

#include <algorithm>
#include <iterator>

namespace pelage::frame {

glm::vec3 random_colour(std::uint32_t strand) {
  const auto channel = [strand](std::uint32_t c) {
    return static_cast<float>(mixed_bits(3U * strand + c) >> 8U) / 16777216.0F;
  };
  return {channel(0), channel(1), channel(2)};
}

void set_random_colours(hair_model& model) {
  model.colour.clear();
  model.colour.reserve(model.points.size());
  for (std::uint32_t strand = 0; strand < model.strand_count(); ++strand)
    std::fill_n(std::back_inserter(model.colour), model.point_count(strand), random_colour(strand));
}

}  // namespace pelage::frame
