// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "frame/scene/solids.hpp"
#include "frame/scene/view.hpp"

namespace pelage::frame {

/// View depth of the nearest opaque object along the rays through all pixels' centres, +inf where there is none.
/// Parallel.
[[nodiscard]] std::vector<float> opaque_depths(const view& from, const solids& opaque);

}  // namespace pelage::frame
