// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>

namespace pelage::vulkan {

/// There is no device to run on: no loader, no driver, none of that name, or a program that was built without Vulkan.
struct no_device : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace pelage::vulkan
