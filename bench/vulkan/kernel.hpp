// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace pelage::vulkan {

/// A compute shader, compiled into the program by pelage_embed_shaders(), so that it runs where no compiler is.
struct kernel {
  std::string_view name;
  std::span<const std::uint32_t> spirv;
};

}  // namespace pelage::vulkan
