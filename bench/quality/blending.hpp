// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "frame/model/strands.hpp"
#include "quality/lists.hpp"

namespace pelage::frame {

/// How far every blending is from sorting every list of a camera's view. Each strand has a random colour, so that a
/// wrong order shows. `alpha`: of all fibres.
[[nodiscard]] nlohmann::json measure_blending(const lists& camera, const strands& fibres, float alpha);

}  // namespace pelage::frame
