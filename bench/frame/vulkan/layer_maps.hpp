// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "frame/settings.hpp"
#include "frame/stage.hpp"
#include "frame/vulkan/scene_block.hpp"

namespace pelage::frame::vulkan {

/// The opacity maps of shaders/layer_map.glsl.

/// Layers of a light's map; 0: it has none.
[[nodiscard]] std::uint32_t light_layers(const frame_settings& settings);

/// Layers of the camera's; 1 for what is summed up over a whole pixel; 0: it has none.
[[nodiscard]] std::uint32_t camera_layers(const frame_settings& settings);

/// Words that a map takes a pixel, its depth range included.
[[nodiscard]] std::uint32_t layer_words(std::uint32_t layers);

/// Says of each view how many layers it has and where they lie. Where deep opacity layers end is found once, as for the
/// CPU's maps: a pass over all fragments, parallel.
void place_layers(scene_block& to, const stage& set, const frame_settings& settings);

}  // namespace pelage::frame::vulkan
