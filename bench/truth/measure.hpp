// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "frame/frame.hpp"
#include "frame/stage.hpp"
#include "truth/error.hpp"
#include "truth/subjects.hpp"
#include "truth/transmittance.hpp"

namespace pelage::truth {

[[nodiscard]] frame::frame_result draw(const subject& s, const frame::frame_settings& settings);

/// A subject's fibres and lights, by rays, and what those see.
class judge {
 public:
  /// O(pixels · samples) rays. `s` must outlive it.
  explicit judge(const subject& s);

  /// A way to draw the subject against the truth, with shadows or without as it says.
  [[nodiscard]] frame_error error_of(const frame::frame_settings& settings) const;
  [[nodiscard]] frame_error error_of(const frame::image& drawn, frame::components shown) const;

  [[nodiscard]] const lighting& scene() const { return scene_; }
  [[nodiscard]] const picture& truth() const { return truth_; }

 private:
  const subject& subject_;
  frame::stage set_;
  fibre_rays fibres_;
  lighting scene_;
  picture truth_;
};

/// Coverage without opaque objects.
struct coverage_error {
  double entries = 0;  ///< summed coverage / fibres met - 1
  double alpha_bias = 0;
  squared_error alpha;
};
[[nodiscard]] coverage_error measure_coverage(const subject& s, float opacity);

/// Straight upright fibres: the sum of a fibre's coverage over the pixels across it, in its widths, and each pixel's.
struct fibre_error {
  double least = 0, mean = 0, greatest = 0;  ///< over the places in a pixel; by rays all are 1
  double rms = 0;                            ///< of a pixel's coverage, in the fibre's widths
};
[[nodiscard]] fibre_error measure_lone_fibres(double radius, int samples);

/// Maps against rays at the places seen.
class shadow_judge {
 public:
  /// `samples`: rays a pixel whose places are taken. The scene must outlive it.
  shadow_judge(const lighting& scene, int samples);

  struct errors {
    std::vector<shadow_error> fibres, opaque;  ///< by light
  };
  [[nodiscard]] errors errors_of(const frame::frame_settings& settings) const;

 private:
  const frame::stage& set_;
  seen_places places_;
  true_shadows truth_;
};

}  // namespace pelage::truth
