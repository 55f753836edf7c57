// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "truth/measure.hpp"

/// What `pelage-truth` prints, in Markdown.
namespace pelage::truth {

/// Summed coverage, alpha bias and RMS, exact lists without opaque objects, for several opacities.
void print_coverage(const subject& s);

/// A lone upright fibre at all places in a pixel, by radius.
void print_lone_fibres();

/// Each light's transmittance at the places seen, by --shadow and --map-size.
void print_transmittance(const subject& s);

/// The frame's RMS by part of the picture, with and without shadows.
void print_split(const subject& s, const judge& rays);

/// The frame's RMS by --map-size, --shadow, --blend and --k.
void print_choices(const subject& s, const judge& rays);

/// Samples and seconds of stochastic rays for the frame's RMS, against the frame's seconds.
void print_times(const std::vector<subject>& subjects, int rounds);

}  // namespace pelage::truth
