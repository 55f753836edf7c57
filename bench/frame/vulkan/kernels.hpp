// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace pelage::frame::vulkan {

/// A shader of shaders/, compiled into the program, so that it runs where no compiler is.
struct kernel {
  std::string_view name;
  std::span<const std::uint32_t> spirv;
};

/// All of them; the list is made by CMakeLists.txt.
extern const std::span<const kernel> all_kernels;

}  // namespace pelage::frame::vulkan
