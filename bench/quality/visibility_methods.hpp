// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/visibility/depth_range.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "quality/lists.hpp"

namespace pelage::frame {

/// What all texels of a map share, and one texel's fragments.
struct texel {
  std::span<const sample> list;
  std::vector<std::uint32_t> optical;  ///< of each fragment
  depth_range range;                   ///< of the texel
  depth_range whole;                   ///< of the map
  float extent;                        ///< of deep opacity layers together
};

/// A visibility structure under test.
struct visibility_method {
  std::string name;
  std::size_t bytes;  ///< a texel, with its depth range; deep shadow maps: 0, counted in `vertices`

  /// Builds the structure from a texel's fragments and fills `passed` with its transmittance before each of some
  /// depths. Adds what a deep shadow map stores to `vertices`.
  void (*estimate)(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t& vertices);
};

/// All that are compared.
[[nodiscard]] std::span<const visibility_method> visibility_methods();

}  // namespace pelage::frame
