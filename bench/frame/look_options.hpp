// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "frame/shading/fibre_bsdf.hpp"

namespace pelage::frame {

/// What the options that say how fibres scatter light were given.
struct look_options {
  std::string model = "kajiya_kay";
  std::string passing = "constant";     ///< as attenuation's names
  std::string colour;                   ///< empty: none
  std::vector<float> melanin;           ///< eumelanin and, if given, pheomelanin
  std::vector<float> beta;              ///< along and, if given, round
  std::vector<CLI::Option*> of_fibres;  ///< what Kajiya-Kay's model has no place for
  std::vector<CLI::Option*> of_lobes;   ///< what it alone has
};

/// Adds the options; those with one number write to `look`. Both must outlive the parsing.
void add_look_options(CLI::App& app, look_options& o, fibre_look& look);

/// The look that the options ask for; throws std::invalid_argument where they do not go together.
void read_look(const look_options& o, fibre_look& look);

[[nodiscard]] std::string name_of(bsdf_model model);

}  // namespace pelage::frame
