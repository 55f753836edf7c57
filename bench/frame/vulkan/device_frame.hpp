// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "frame/frame.hpp"
#include "vulkan/no_device.hpp"

namespace pelage::frame {

/// A frame that a Vulkan device drew, some number of times.
struct device_frame {
  struct pass {
    std::string view;     ///< "light 1", …, "camera"
    std::string name;     ///< the kernel's, or what was cleared; what runs for each layer counts as one pass
    double milliseconds;  ///< median over the frames, by the device's clock
  };
  struct fragments {
    std::uint64_t offered;
    std::uint32_t longest;  ///< fragments of the pixel that has most
    std::uint32_t refused;  ///< that found no place: 0, or the frame is wrong
  };
  image picture;  ///< of the last frame
  std::string device;
  std::vector<pass> passes;
  std::vector<fragments> views;  ///< in the order of passes
  double milliseconds;           ///< median of the whole frames
  std::uint64_t bytes;           ///< of the device's memory
  std::uint64_t hash;            ///< of the first picture's bits; of hair that moves, of all pictures' hashes in order
  std::uint32_t frames;          ///< timed, after a tenth as many to warm up
  std::uint32_t same;         ///< of those, how many have that hash; of hair that moves, how many have the same again
                              ///< when the sequence is drawn a second time
  std::uint32_t redrawn = 0;  ///< how often moving hair outgrew its room, so that a frame was drawn again with more
  drawn_report drawn{};
};

using pelage::vulkan::no_device;

/// Draws a frame on a Vulkan device, all of it from strands to picture: that of draw_frame() except for rounding, where
/// segments are lit at their ends alone, whatever the settings' shading_spacing.
///
/// `frames`: [1, inf). `degrees`: as draw_turn() has them, and then each frame's passes are those of a place of its
/// own, as they are where a wind blows. The layers of --blend depth_peeling are counted before each frame, apart from
/// its time. Throws no_device; std::runtime_error, one line, for too little memory, a model too large for the device,
/// and what its shaders do not have; and as draw_frame().
[[nodiscard]] device_frame draw_frame_on_device(const hair_model& model, const frame_settings& settings,
                                                std::uint32_t frames, float degrees = 0.0F);

}  // namespace pelage::frame
