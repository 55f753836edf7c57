// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>

#include "frame/settings.hpp"

namespace pelage::frame {

/// What the user asks the program for.
struct command_line {
  std::string hair;                 ///< a .hair or .tfx file; empty: the built-in model
  std::uint32_t follow = 0;         ///< follow strands for each strand of the file
  float follow_radius = 0.0F;       ///< length units; 0: 0.6 % of the model's size
  std::uint32_t interpolate = 0;    ///< strands between guides for each strand of the file
  float clump = 0.0F;               ///< of those, [0, 1]
  std::uint32_t strands = 50000;    ///< of the built-in model
  std::uint32_t segments = 48;      ///< of each of its strands
  std::uint64_t seed = 1;           ///< of the built-in model, follow strands and stochastic blending
  int threads = 0;                  ///< 0: one a core
  bool on_device = false;           ///< drawn by Vulkan
  std::uint32_t frames = 1;         ///< that a device draws, to be timed, or of a turn
  float turn = 0.0F;                ///< the camera's from frame to frame, degrees of azimuth
  std::string shadow = "k_buffer";  ///< as parse_shadow() reads it
  std::string blend = "k_buffer";   ///< as parse_blend() reads it
  std::string tail = "mean";        ///< as parse_tail() reads it
  bool random_colours = false;      ///< a colour a strand, by its number, in place of the model's
  std::string out = "out/frame.png";
  std::string report;   ///< a JSON file; empty: none
  std::string compare;  ///< a PNG; empty: none
  frame_settings settings;
};

/// Throws CLI::Success for --help, CLI::ParseError or std::invalid_argument for what cannot be read.
[[nodiscard]] command_line parse_command_line(CLI::App& app, int argc, char** argv);

/// The word that chooses a method or the parts that are drawn.
[[nodiscard]] std::string name_of(order_method method);
[[nodiscard]] std::string name_of(components shown);

}  // namespace pelage::frame
