// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "frame/frame.hpp"
#include "frame/stage.hpp"
#include "truth/error.hpp"
#include "truth/transmittance.hpp"

namespace pelage::truth {

/// What a measurement is made of: a model, how it is drawn, and by how many rays it is judged.
struct subject {
  frame::hair_model model;
  frame::frame_settings settings;
  int samples = 64;  ///< rays a pixel in each half of the truth
};

/// The built-in model at a size, as pelage-frame draws it by default.
[[nodiscard]] subject built_in(std::uint32_t strands, std::uint32_t segments, int size, int samples);

[[nodiscard]] frame::image draw(const subject& s, const frame::frame_settings& settings);

/// Coverage without opaque objects, opacity ½.
struct coverage_error {
  double entries = 0;  ///< summed coverage / fibres met - 1
  double alpha_bias = 0;
  squared_error alpha;
};
[[nodiscard]] coverage_error measure_coverage(const subject& s);

/// Transmittances at the places seen, [light], by one way to make maps.
struct light_errors {
  std::vector<shadow_error> fibres, opaque;
};
/// Rays and places of a subject, for any number of maps.
class shadow_judge {
 public:
  /// `samples`: rays a pixel whose places are taken.
  shadow_judge(const lighting& scene, int samples)
      : set_(scene.set()), places_(places_seen(scene, samples, 3)), truth_(shadows_at(scene, places_)) {}
  [[nodiscard]] light_errors judge(const frame::frame_settings& settings) const;

 private:
  const frame::stage& set_;
  seen_places places_;
  true_shadows truth_;
};

}  // namespace pelage::truth
