// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "frame/solids.hpp"
#include "frame/view.hpp"

namespace pelage::frame {

/// View depth of the nearest opaque object along the ray through pixel coordinates, +inf where there is none.
[[nodiscard]] float opaque_depth(const view& from, const solids& opaque, const glm::vec2& pixel);

/// The same for all pixels' centres. Parallel.
[[nodiscard]] std::vector<float> opaque_depths(const view& from, const solids& opaque);

}  // namespace pelage::frame
