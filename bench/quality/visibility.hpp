// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "quality/lists.hpp"

namespace pelage::frame {

/// How far every visibility method is from the truth at every fragment of a light's view, what it keeps a texel and
/// how long it takes, and what each says along two rays: that of most fragments, and one that meets a stray strand
/// before the mass. `alpha`: of all fibres. Null without fragments.
[[nodiscard]] nlohmann::json measure_visibility(const lists& light, float alpha);

}  // namespace pelage::frame
