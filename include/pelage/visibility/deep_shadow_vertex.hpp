// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/version.hpp>

namespace pelage::inline PELAGE_ABI {

/// A point of a deep shadow map's transmittance function. A file of its own, since a shader declares a buffer of them
/// before it includes the map. 8 bytes.
struct deep_shadow_vertex {
  float depth;          ///< [-2¹⁰⁰, 2¹⁰⁰]
  float transmittance;  ///< [0, 1]
};

}  // namespace pelage
