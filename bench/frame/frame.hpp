// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "frame/image/image.hpp"
#include "frame/model/hair_model.hpp"
#include "frame/order/order_pass.hpp"
#include "frame/settings.hpp"
#include "frame/stage.hpp"

namespace pelage::frame {

/// One pass over the fibres: a light's map or the camera's picture.
struct pass_report {
  std::string name;
  double prepare_seconds;  ///< projection of all points
  order_report order;
  std::uint64_t bytes;       ///< of the map or picture that it made
  double shade_seconds = 0;  ///< radiance of fibres and opaque objects, for the camera
};

struct frame_result {
  image picture;
  std::vector<pass_report> passes;
  double seconds = 0;  ///< all passes, without loading and saving
  drawn_report drawn{};
};

/// Draws a frame. `progress` is called between passes with their name and the share that is done, [0, 1].
/// Throws std::invalid_argument for a setting out of range.
[[nodiscard]] frame_result draw_frame(const hair_model& model, const frame_settings& settings,
                                      const std::function<void(const std::string&, double)>& progress);

/// The same of a stage that set_up() made with these settings, or move_camera() or move_hair() after it.
[[nodiscard]] frame_result draw_frame(const stage& set, const frame_settings& settings,
                                      const std::function<void(const std::string&, double)>& progress);

/// Where the camera of one of a turn's frames stands: `degrees` of azimuth beyond that of the frame before. `first`: of
/// frame 0.
[[nodiscard]] inline glm::vec2 turned(const glm::vec2& first, float degrees, std::uint32_t frame) {
  return {first.x + degrees * static_cast<float>(frame), first.y};
}

/// Draws frames of a camera that goes round the model, and gives the last: what draw_frame() makes from there, except
/// that the order of --blend sliced is kept until it is stale. Where a wind blows the camera stands and the last frame
/// alone is drawn: it does not depend on those before. `frames`: [1, inf).
[[nodiscard]] frame_result draw_turn(const hair_model& model, const frame_settings& settings, std::uint32_t frames,
                                     float degrees, const std::function<void(const std::string&, double)>& progress);

}  // namespace pelage::frame
