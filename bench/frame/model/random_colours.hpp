// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

#include <cstdint>

#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// A strand's colour by its number alone, each channel in [0, 1): where neighbours differ, a wrong order shows [Yu12,
/// Fig. 8].
[[nodiscard]] glm::vec3 random_colour(std::uint32_t strand);

/// Gives each strand its random colour in place of its own. Follow strands have numbers of their own. O(points).
void set_random_colours(hair_model& model);

}  // namespace pelage::frame
