// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/device_frame.hpp"

namespace pelage::frame {

device_frame draw_frame_on_device(const hair_model&, const frame_settings&, std::uint32_t, float) {
  throw no_device("--device vulkan: this program was built without Vulkan's headers or without glslc");
}

}  // namespace pelage::frame
