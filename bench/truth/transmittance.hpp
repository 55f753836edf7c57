// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "frame/shading/scene.hpp"
#include "truth/frame_side.hpp"
#include "truth/lighting.hpp"

namespace pelage::truth {

/// Places that the camera sees, each with its visible share.
struct seen_places {
  std::vector<frame::lit_place> fibre;
  std::vector<double> fibre_share;
  std::vector<ray> opaque;  ///< as the camera's ray to it
  std::vector<double> opaque_share;
};

/// Those on `samples` rays a pixel, down to a share of 1/1000.
[[nodiscard]] seen_places places_seen(const lighting& scene, int samples, std::uint64_t seed);

/// What rays say of the same places and lights: [light][place].
struct true_shadows {
  std::vector<std::vector<double>> to_fibres, to_opaque;
};
[[nodiscard]] true_shadows shadows_at(const lighting& scene, const seen_places& places);

/// A map's transmittances against rays, all weighted by the visible share.
struct shadow_error {
  double mean_truth = 0;
  double ratio = 0;  ///< mean of the map / mean of the truth - 1
  double rms = 0;    ///< of the difference at a place
};
[[nodiscard]] shadow_error compare(const std::vector<double>& drawn, const std::vector<double>& truth,
                                   const std::vector<double>& share);

}  // namespace pelage::truth
