// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "frame/model/hair_model.hpp"
#include "frame/model/placement.hpp"
#include "frame/model/strands.hpp"
#include "frame/model/sway.hpp"
#include "frame/order/slice_order.hpp"
#include "frame/scene/lights.hpp"
#include "frame/scene/solids.hpp"
#include "frame/scene/view.hpp"
#include "frame/settings.hpp"

namespace pelage::frame {

/// A model's strands before copies and detail.
struct whole_model {
  strands fibres;
  std::vector<std::uint32_t> first_point;  ///< as in hair_model
  std::vector<placement> copies;           ///< where it stands
};

/// All that stands before the lights and the camera, and where those stand: what a frame draws on any device.
struct stage {
  std::optional<whole_model> whole;  ///< of a crowd, or with detail_errors; else `fibres` are the model's
  strands fibres;
  swaying_hair hair;               ///< of the model's fibres, where a wind blows
  std::uint32_t strand_count = 0;  ///< of the fibres
  double detail_seconds = 0.0;     ///< what it took to choose them, all times together
  box bounds;                      ///< of all copies of the model, wherever the wind takes their fibres
  sphere round;                    ///< round that
  solids opaque;
  glm::vec3 sky;                             ///< light from all sides, linear RGB
  std::vector<light> lights;                 ///< placed
  std::vector<view> light_views;             ///< one a light
  view eye;                                  ///< the camera's
  std::vector<std::uint32_t> drawing_order;  ///< segments' numbers; empty: 0, 1, 2…
  slice_order slices;                        ///< of the camera, if the blend asks for it
  glm::vec2 from;                            ///< where the camera stands, as in the settings
};

/// Where a wind blows, its frame 0. Throws std::invalid_argument for a setting out of range and a model that float's
/// range does not hold.
[[nodiscard]] stage set_up(const hair_model& model, const frame_settings& settings);

/// At which depths one of the stage's views takes the widths of lines: 256 bins for the camera, the middle of the
/// fibres for a light. [Svoboda §1.2.3]
[[nodiscard]] line_depths line_depths_of(const stage& s, const view& from);

/// Moves the camera, and lights that go with it, to where the settings say: afterwards a stage is as set_up() makes it,
/// except that the slices' order of strands without detail stays until it is stale.
void move_camera(stage& s, const frame_settings& settings);

/// Moves the hair to where the wind has it in a frame; nothing where none blows.
void move_hair(stage& s, const frame_settings& settings, std::uint32_t frame);

/// Of the strands that are drawn.
struct drawn_report {
  std::uint32_t strands = 0;
  std::uint32_t segments = 0;
  double detail_seconds = 0;  ///< what it took the CPU to choose them, in all frames
  std::uint32_t sorts = 0;    ///< of the slices' order, in all frames
  double sort_seconds = 0;    ///< what they took
};

[[nodiscard]] drawn_report report_of(const stage& s);

/// How the stage's fibres scatter light. Throws as fibre_bsdf does.
[[nodiscard]] fibre_bsdf make_bsdf(const stage& set, const fibre_look& look);

}  // namespace pelage::frame
