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
};

/// Draws a frame. `progress` is called between passes with their name and the share that is done, [0, 1].
/// Throws std::invalid_argument for a setting out of range.
[[nodiscard]] frame_result draw_frame(const hair_model& model, const frame_settings& settings,
                                      const std::function<void(const std::string&, double)>& progress);

}  // namespace pelage::frame
