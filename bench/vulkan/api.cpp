// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "vulkan/api.hpp"

#include <dlfcn.h>

#include "vulkan/no_device.hpp"

namespace pelage::vulkan {

void api::open() {
  // The loader stays open: drivers leave threads and exit handlers behind.
  void* loader = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
  if (loader == nullptr) throw no_device(caller + ": there is no Vulkan loader, libvulkan.so.1");
  vkGetInstanceProcAddr = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(loader, "vkGetInstanceProcAddr"));
  if (vkGetInstanceProcAddr == nullptr) throw error("libvulkan.so.1 is no Vulkan loader");
}

void api::load(VkInstance instance) {
#define X(name) find(instance, name, #name);
  PELAGE_VULKAN_INSTANCE_FUNCTIONS(X)
#undef X
}

void api::load(VkDevice device) {
#define X(name) set(name, vkGetDeviceProcAddr(device, #name), #name);
  PELAGE_VULKAN_DEVICE_FUNCTIONS(X)
#undef X
}

void api::check(VkResult result, const std::string& what) const {
  if (result == VK_SUCCESS) return;
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) {
    throw error("not enough memory for " + what);
  }
  if (result == VK_ERROR_DEVICE_LOST) throw error("the device was lost at " + what);
  throw error(what + " failed with VkResult " + std::to_string(result));
}

}  // namespace pelage::vulkan
